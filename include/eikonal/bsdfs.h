/* Every BSDF and its parameters, as the shading kernel finds them in its hit queue, textures already evaluated.
   B(name, FEATURE, PARAMETERS).  A BSDF called x is kernels/bsdf/x.clh, which defines eval_x, sample_x and pdf_x. */
#ifndef EIKONAL_BSDFS_H
#define EIKONAL_BSDFS_H
#include "eikonal/portable.h"

/* Lambertian reflection. */
#define DIFFUSE_PARAMETERS(F, q) \
    F(q, spectrum, reflectance,   ALWAYS)    /* albedo, in [0, 1] */

/* Lambertian reflection and transmission. */
#define DIFFUSE_TRANSMISSION_PARAMETERS(F, q) \
    F(q, spectrum, reflectance,   ALWAYS)    /* reflectance + transmittance is at most 1 */ \
    F(q, spectrum, transmittance, ALWAYS)

/* A metal with GGX microfacets. */
#define CONDUCTOR_PARAMETERS(F, q) \
    F(q, spectrum, eta,           ALWAYS)    /* complex index of refraction: real part */ \
    F(q, spectrum, k,             ALWAYS)    /* its imaginary part */ \
    F(q, float,    alpha_x,       ALWAYS)    /* microfacet widths along and across the tangent, at least MIN_ALPHA */ \
    F(q, float,    alpha_y,       ALWAYS)

/* The same metal with the light that bounces more than once between its microfacets. */
#define COMPENSATED_CONDUCTOR_PARAMETERS(F, q) \
    F(q, uint,     energy,        ALWAYS)    /* in `energy_tables` */ \
    CONDUCTOR_PARAMETERS(F, q)

/* A polished metal. */
#define SPECULAR_CONDUCTOR_PARAMETERS(F, q) \
    F(q, spectrum, eta,           ALWAYS) \
    F(q, spectrum, k,             ALWAYS)

/* A dielectric interface with GGX microfacets. */
#define DIELECTRIC_PARAMETERS(F, q) \
    F(q, float,    eta,           ALWAYS)    /* index inside over index outside */ \
    F(q, float,    alpha_x,       ALWAYS) \
    F(q, float,    alpha_y,       ALWAYS)

/* The same interface with the light that meets its microfacets more than once. */
#define COMPENSATED_DIELECTRIC_PARAMETERS(F, q) \
    F(q, uint,     energy,        ALWAYS)    /* in `energy_tables` */ \
    DIELECTRIC_PARAMETERS(F, q)

/* A smooth dielectric interface. */
#define SPECULAR_DIELECTRIC_PARAMETERS(F, q) \
    F(q, float,    eta,           ALWAYS)

/* A thin dielectric slab: both of its interfaces. */
#define THIN_DIELECTRIC_PARAMETERS(F, q) \
    F(q, float,    eta,           ALWAYS)

/* A dielectric coat over a diffuse base with a medium in between: the layered random walk of Guo et al. 2018. */
#define COATED_DIFFUSE_PARAMETERS(F, q) \
    F(q, spectrum, reflectance,   ALWAYS)    /* of the base */ \
    F(q, float,    eta,           ALWAYS)    /* index of the coat over index outside */ \
    F(q, float,    alpha_x,       ALWAYS)    /* of the coat; below MIN_ALPHA: smooth */ \
    F(q, float,    alpha_y,       ALWAYS) \
    F(q, float,    thickness,     ALWAYS)    /* of the medium, optical */ \
    F(q, spectrum, albedo,        ALWAYS)    /* of the medium; 0: it only absorbs */ \
    F(q, float,    g,             ALWAYS)    /* of the medium: mean cosine */ \
    F(q, uint,     max_depth,     ALWAYS)    /* most events of a walk */ \
    F(q, uint,     samples,       ALWAYS)    /* walks per evaluation */ \
    F(q, uint,     key,           ALWAYS)    /* of the walks' random numbers; another one for each vertex of each path */

/* The same coat and medium over a conductor. */
#define COATED_CONDUCTOR_PARAMETERS(F, q) \
    F(q, spectrum, metal_eta,     ALWAYS)    /* of the metal, relative to vacuum */ \
    F(q, spectrum, metal_k,       ALWAYS) \
    F(q, float,    metal_alpha_x, ALWAYS)    /* of the metal; below MIN_ALPHA: smooth */ \
    F(q, float,    metal_alpha_y, ALWAYS) \
    F(q, float,    eta,           ALWAYS)    /* from here on as in COATED_DIFFUSE_PARAMETERS */ \
    F(q, float,    alpha_x,       ALWAYS) \
    F(q, float,    alpha_y,       ALWAYS) \
    F(q, float,    thickness,     ALWAYS) \
    F(q, spectrum, albedo,        ALWAYS) \
    F(q, float,    g,             ALWAYS) \
    F(q, uint,     max_depth,     ALWAYS) \
    F(q, uint,     samples,       ALWAYS) \
    F(q, uint,     key,           ALWAYS)

/* Plastic to metal, under a clear coat, with sheen. */
#define PRINCIPLED_PARAMETERS(F, q) \
    F(q, spectrum, base,          ALWAYS)    /* diffuse albedo; of metal: reflectance at normal incidence. In [0, 1] */ \
    F(q, float,    metallic,      ALWAYS)    /* 0: plastic, 1: metal */ \
    F(q, float,    eta,           ALWAYS)    /* index of the plastic, at least 1 */ \
    F(q, float,    alpha_x,       ALWAYS)    /* of plastic and metal */ \
    F(q, float,    alpha_y,       ALWAYS) \
    F(q, float,    coat,          ALWAYS)    /* weight of the clear coat, in [0, 1] */ \
    F(q, float,    coat_alpha,    ALWAYS) \
    F(q, float,    sheen,         ALWAYS)    /* in [0, 1] */

/* A hair fibre: the four lobes of Chiang et al. 2016. The tangent is the fibre's axis. */
#define HAIR_PARAMETERS(F, q) \
    F(q, spectrum, sigma_a,       ALWAYS)    /* absorption per fibre radius */ \
    F(q, float,    h,             ALWAYS)    /* offset across the fibre, in [-1, 1] */ \
    F(q, float,    eta,           ALWAYS) \
    F(q, float,    beta_m,        ALWAYS)    /* roughness along the fibre, in [0, 1] */ \
    F(q, float,    beta_n,        ALWAYS)    /* roughness around the fibre, in [0, 1] */ \
    F(q, float,    scale_tilt,    ALWAYS)    /* angle of the cuticle scales, degrees */

/* Measured by a goniophotometer. */
#define MEASURED_PARAMETERS(F, q) \
    F(q, uint,     file,          ALWAYS)    /* in `measured_files` */

/* The surface where a path leaves a body with a diffusion profile: Lambertian below the interface. */
#define SUBSURFACE_EXIT_PARAMETERS(F, q) \
    F(q, spectrum, weight,        ALWAYS)    /* profile over the density of sampling this exit point */ \
    F(q, spectrum, albedo,        ALWAYS)    /* of the body, in [0, 1] */ \
    F(q, float,    eta,           ALWAYS)    /* index inside over index outside */ \
    F(q, float,    passing,       ALWAYS)    /* transmittance of the interface for diffuse light, in (0, 1] */

/* A point in a medium, where light paths are traced: there a hit whose BSDF is the phase function of Henyey and Greenstein (1941). */
#define HENYEY_GREENSTEIN_PARAMETERS(F, q) \
    F(q, float,    g,             ALWAYS)    /* mean cosine of the scattering angle, in (-1, 1) */

#define BSDFS(B) \
    B(diffuse,              BSDF_DIFFUSE,              DIFFUSE_PARAMETERS) \
    B(diffuse_transmission, BSDF_DIFFUSE_TRANSMISSION, DIFFUSE_TRANSMISSION_PARAMETERS) \
    B(conductor,            BSDF_CONDUCTOR,            CONDUCTOR_PARAMETERS) \
    B(specular_conductor,   BSDF_SPECULAR_CONDUCTOR,   SPECULAR_CONDUCTOR_PARAMETERS) \
    B(dielectric,           BSDF_DIELECTRIC,           DIELECTRIC_PARAMETERS) \
    B(specular_dielectric,  BSDF_SPECULAR_DIELECTRIC,  SPECULAR_DIELECTRIC_PARAMETERS) \
    B(thin_dielectric,      BSDF_THIN_DIELECTRIC,      THIN_DIELECTRIC_PARAMETERS) \
    B(coated_diffuse,       BSDF_COATED_DIFFUSE,       COATED_DIFFUSE_PARAMETERS) \
    B(coated_conductor,     BSDF_COATED_CONDUCTOR,     COATED_CONDUCTOR_PARAMETERS) \
    B(principled,           BSDF_PRINCIPLED,           PRINCIPLED_PARAMETERS) \
    B(hair,                 BSDF_HAIR,                 HAIR_PARAMETERS) \
    B(measured,             BSDF_MEASURED,             MEASURED_PARAMETERS) \
    B(subsurface_exit,            BSDF_SUBSURFACE_EXIT,            SUBSURFACE_EXIT_PARAMETERS) \
    B(compensated_conductor,      BSDF_COMPENSATED_CONDUCTOR,      COMPENSATED_CONDUCTOR_PARAMETERS) \
    B(compensated_dielectric,     BSDF_COMPENSATED_DIELECTRIC,     COMPENSATED_DIELECTRIC_PARAMETERS) \
    B(henyey_greenstein,          BSDF_HENYEY_GREENSTEIN,          HENYEY_GREENSTEIN_PARAMETERS)

/* Narrower microfacets are treated as a mirror (pbrt-v4's limit for "effectively smooth"). */
#define MIN_ALPHA 1e-3f

#endif
