/* Render passes: the light of an image by the way that it took, in four layers that sum to the image. The first thing that a path meets
   from the camera on decides; null interfaces do not count, nor does scattering inside a subsurface body. The pass of a path is that of the
   light that its ray may meet next. */
#ifndef EIKONAL_RENDER_PASSES_H
#define EIKONAL_RENDER_PASSES_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

enum render_pass {
    pass_emission,    /* nothing: surfaces that emit and environments, as the camera sees them */
    pass_direct,      /* a surface, and no other before the light */
    pass_indirect,    /* a surface, and more after it */
    pass_volume,      /* a medium, which scatters the light or emits it */
    render_passes     /* how many there are */
};

CONTRACT_END
#endif
