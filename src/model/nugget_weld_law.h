// SPDX-License-Identifier: Apache-2.0
// The user's own failure function of spot welds, OPT 2, 12 and 22 of *MAT_SPOTWELD_DAMAGE-FAILURE, in a shared library
// of C, C++ or Fortran (bind(c)): nugget run MODEL.k --weld-law FILE.so. Docs: docs/manual/weld_law.md.
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

enum { NUGGET_WELD_LAW_VERSION = 1, NUGGET_WELD_VALUES = 22 };

/* A weld, the same in all calls. Lengths in the deck's units. */
struct nugget_weld {
  int id;                            /* of its element or assembly */
  int part;                          /* id of its part */
  int option;                        /* OPT: 2, 12 or 22 */
  int sheet[2];                      /* ids of the parts that its ends are tied to; 0: none */
  double thickness[2];               /* of those sheets; 0: none */
  double diameter, length;           /* at the start */
  double area;                       /* of its section */
  double section_modulus;            /* of bending; that of torsion is twice as large */
  double value[NUGGET_WELD_VALUES];  /* USRV1 to USRV22 */
};

/* Its load in a cycle, resultants filtered over NF cycles. */
struct nugget_weld_load {
  double time, step;                  /* of the model */
  double axial;                       /* N_rr, tension positive */
  double shear_s, shear_t;            /* N_rs, N_rt */
  double torsion;                     /* M_rr */
  double moment_s, moment_t;          /* M_ss, M_tt */
  double strain_rate;                 /* effective */
  double plastic_strain;              /* mean over the weld */
};

/* What a library must have.
   NUGGET_WELD_LAW_VERSION as it was compiled with. */
int nugget_weld_law_version(void);
/* The failure value: the weld fails, or its damage begins, in the cycle in which it reaches 1. Called once a cycle for
   each weld that holds, in any order; may use nothing that changes but `memory`. Must not throw. */
double nugget_weld_law(const struct nugget_weld* weld, const struct nugget_weld_load* load, double* memory);

/* What it may have: how many numbers of `memory` a weld needs. They are 0 at the start, stay from cycle to cycle, and
   stand in restart files. */
int nugget_weld_law_memory(const struct nugget_weld* weld);

#ifdef __cplusplus
}
#endif
