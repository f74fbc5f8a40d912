/* The dimension of the random sequence that each decision uses. A random number is a function of (pixel, sample, dimension, seed).
   No two decisions share a dimension, so the order in which paths are processed does not affect the image. */
#ifndef EIKONAL_DIMENSIONS_H
#define EIKONAL_DIMENSIONS_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

enum camera_dimension {
    dimension_pixel,           /* 2D: position in the pixel filter */
    dimension_lens,            /* 2D: position on the lens */
    dimension_time,            /* 1D: time in the shutter interval */
    dimension_wavelength,      /* 1D: wavelengths; with SPECTRAL_FILM 2D */
    camera_dimensions = 8
};

/* Light paths have a seed of their own, and other uses for two of these. */
enum light_path_dimension {
    dimension_emission_point = dimension_pixel,      /* 2D: choice of the light, and the point on it */
    dimension_emission_direction = dimension_lens    /* 2D */
};

/* Per bounce; the dimension is camera_dimensions + depth * bounce_dimensions + one of these. */
enum bounce_dimension {
    dimension_light,           /* 1D: choice of a light in the light tree */
    dimension_light_point,     /* 2D: choice of a light by the alias table, and the point on it; of a light path: point of the lens */
    dimension_lobe,            /* 1D: choice of a BSDF lobe */
    dimension_direction,       /* 2D: direction within the lobe */
    dimension_roulette,        /* 1D: Russian roulette */
    dimension_mix,             /* 1D: choice of a material in a mix */
    dimension_walk,            /* seed: the random walks of layered BSDFs */
    dimension_distance,        /* seed of a random stream: distance sampling in media */
    dimension_transmittance,   /* seed of a random stream: transmittance of a shadow ray through media */
    dimension_alpha,           /* seed: alpha tests */
    dimension_probe_axis,      /* 1D: axis of the probe ray and channel of the diffusion profile */
    dimension_probe,           /* 2D: distance and azimuth of the probe ray; both, with FORCE_DIFFUSE: samples of a reflectance */
    dimension_exit,            /* seed: choice among the exit points of a probe ray */
    dimension_splat,           /* seed: of a light path: the pixel that a connection to the camera counts for */
    dimension_vertex,          /* 1D: of a light path: whether the vertex is stored */
    dimension_connection,      /* seed of a random stream: choice of the hit of a light path to connect with */
    bounce_dimensions = 16
};

CONTRACT_END
#endif
