/* Which sample of which pixel each path of a batch is. */
#ifndef EIKONAL_BATCH_H
#define EIKONAL_BATCH_H
#include "eikonal/portable.h"
CONTRACT_BEGIN

/* The most batches that share one wave. */
#define MOST_BATCHES 16

/* One sample of each pixel of a block: one path per pixel, row by row. */
typedef struct {
    uint x, y;      /* upper left pixel of the block */
    uint sample;    /* sample index of every pixel */
} layer;

/* The layers of one block, ordered by sample. */
typedef struct {
    uint first;     /* index among the layers of the batch */
    uint layers;
} layer_range;

CONTRACT_END
#endif
