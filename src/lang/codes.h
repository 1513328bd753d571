/* codes.h - the values of the constants that scripts pass to functions
 * (spec/language 10). They are part of the language: files and scripts may
 * hold the bare numbers. */
#ifndef LANG_CODES_H
#define LANG_CODES_H

enum { IX__COL = 1301, IX__ROW = 1302, IX__DEPTH = 1303 };

enum {
    IX__KV_OPEN = -10000,
    IX__KV_FLOAT = -10001,
    IX__KV_PERIODIC = -10002,
    IX__KV_DISC_OPEN = -10003
};

enum {
    IX__PARAM_UNIFORM = 1501,
    IX__PARAM_CENTRIP = 1502,
    IX__PARAM_CHORD = 1503,
    IX__PARAM_NIELFOL = 1504
};

enum {
    IX__BEZIER_TYPE = 5001,
    IX__BSPLINE_TYPE = 5002,
    IX__POWER_TYPE = 5003,
    IX__GREGORY_TYPE = 5004
};

/* En is IX__E1 + 2 (n - 1), Pn one more. */
enum { IX__E1 = 1100, IX__P1 = 1101 };

/* The GeomType attribute of constructed freeforms. */
enum {
    IX__GEOM_LINEAR = 1,
    IX__GEOM_CIRCULAR = 2,
    IX__GEOM_CONIC = 3,
    IX__GEOM_TRIVAR_RULED = 5, /* as written for trivariates */
    IX__GEOM_SRF_OF_REV = 9,
    IX__GEOM_BOOL_SUM = 11,
    IX__GEOM_EXTRUSION = 12,
    IX__GEOM_RULED = 13,
    IX__GEOM_DEVELOP = 14,
    IX__GEOM_SWEEP = 15
};

#endif
