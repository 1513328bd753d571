/* angle.h - pi, which C11 does not name, and degrees. */
#ifndef GEOM_ANGLE_H
#define GEOM_ANGLE_H

#define IX__PI         3.14159265358979323846
#define IX__DEG(x)     ((x) * 180 / IX__PI)
#define IX__RADIANS(x) ((x) * IX__PI / 180)

#endif
