/* How much light microfacets lose because they scatter it once: tables for the BSDFs that compensate it (kernels/bsdf/lost_energy.clh).
   A record, in the table of floats `energy_values`, belongs to widths alpha_x and alpha_y, a side and an index of refraction:
     its average over the hemisphere, weighted by the cosine
     of the light that is scattered once, the share that is transmitted
     for each azimuth, for each cosine: the fraction lost of what arrives from there */
#ifndef EIKONAL_MICROFACET_ENERGY_H
#define EIKONAL_MICROFACET_ENERGY_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

/* Words of a record before its directions, and nodes along the cosine c: at (c (1 + a) / (c + a))^(1/2) = 0 ... 1, where a - 0.3 is the
   width in the direction of the azimuth. */
enum energy_record { energy_average, energy_transmitted, energy_directions, ENERGY_COSINES = 65 };

/* Of a surface whose widths, and index, may vary. An axis of 1 node is constant. */
typedef struct {
    uint first;              /* in `energy_values`: records by index, side, alpha_y, alpha_x; alpha_x fastest */
    uint azimuths;           /* nodes at y / (x + y) = 0 ... 1; 1: isotropic */
    uint widths_x, widths_y; /* nodes at a / (1 + a) = 0 ... MOST_ENERGY_WIDTH; alpha_y has 1 if it is alpha_x */
    uint sides;              /* 2: outside and inside; 1: nothing is transmitted */
    uint indices;            /* nodes from first_index on, per unit of the index */
    float first_index, indices_per_unit;
} energy_table;

#define MOST_ENERGY_WIDTH 0.95f

CONTRACT_END
#endif
