/* Which dimension of the random sequence each decision uses. A number is a function of (pixel, sample, dimension, seed):
   no decision shares its dimension with another, so the order in which paths run cannot matter. */
#ifndef EIKONAL_DIMENSIONS_H
#define EIKONAL_DIMENSIONS_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

enum camera_dimension {
    dimension_pixel,           /* 2D: where in the pixel's filter */
    dimension_lens,            /* 2D: where on the lens */
    dimension_time,            /* 1D: when in the shutter's interval */
    dimension_wavelength,      /* 1D: which wavelengths; with SPECTRAL_FILM 2D */
    camera_dimensions = 8
};

/* For each bounce; the dimension is camera_dimensions + depth * bounce_dimensions + one of these. */
enum bounce_dimension {
    dimension_light,           /* 1D: which light of a tree */
    dimension_light_point,     /* 2D: which light of a few, and where on it */
    dimension_lobe,            /* 1D: which lobe of the BSDF */
    dimension_direction,       /* 2D: which direction of it */
    dimension_roulette,        /* 1D: whether to go on */
    dimension_mix,             /* 1D: which material of a mix */
    dimension_walk,            /* seed of further random numbers: layered BSDFs */
    dimension_distance,        /* seed of further random numbers: tracking through a medium */
    dimension_transmittance,   /* seed of further random numbers: a shadow ray through media */
    dimension_alpha,           /* seed: cut-outs on the way */
    dimension_probe_axis,      /* 1D: along which axis to look for where light leaves a body, and for which channel's profile */
    dimension_probe,           /* 2D: how far away, and in which direction */
    dimension_exit,            /* seed: which of the points that a probe has met */
    bounce_dimensions = 16
};

CONTRACT_END
#endif
