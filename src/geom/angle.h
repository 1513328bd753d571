/* angle.h - pi, which C11 does not name, and degrees. */
#ifndef GEOM_ANGLE_H
#define GEOM_ANGLE_H

#define IX__PI         3.14159265358979323846
#define IX__DEG(x)     (180 * (x) / IX__PI)
#define IX__RADIANS(x) (IX__PI * (x) / 180)

#endif
