/* Every kind of material.   M(name): material x is host/kinds/material/x.cpp, which says what a scene's material has for parameters, and
   which BSDF of BSDFS (bsdfs.h) scatters light at it: a smooth one may have another than a rough one. */
#ifndef EIKONAL_MATERIALS_H
#define EIKONAL_MATERIALS_H

#define MATERIALS(M) \
    M(diffuse) \
    M(coated_diffuse) \
    M(conductor) \
    M(dielectric) \
    M(thin_dielectric) \
    M(diffuse_transmission) \
    M(mix) \
    M(interface) \
    M(coated_conductor) \
    M(subsurface) \
    M(hair) \
    M(measured) \
    M(principled)

#endif
