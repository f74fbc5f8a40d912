/* How the paths of a wave stand for samples of pixels. */
#ifndef EIKONAL_BATCH_H
#define EIKONAL_BATCH_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

/* Of how many batches a wave may have paths in flight. */
#define MOST_BATCHES 16

/* One sample of each pixel of a block: as many paths as the block has pixels, row after row. */
typedef struct {
    uint x, y;      /* the block's upper left pixel */
    uint sample;    /* which of each pixel */
} layer;

/* The layers of a block, in the order of the samples. */
typedef struct {
    uint first;     /* layer of the batch */
    uint layers;
} layer_range;

CONTRACT_END
#endif
