// Each part of packing can write its own tables, and no others: what would write another's does not compile.

#include "kinds/light_packing.h"
#include "kinds/medium_packing.h"
#include "kinds/shape_packing.h"
#include "pack/camera.h"
#include "pack/geometry.h"

namespace eikonal {
namespace {

#define CAN_WRITE(Concept, table) \
    template <class Packing> concept Concept = requires(const Packing& in) { in.tables.table.clear(); };
CAN_WRITE(WritesShapes, shapes)
CAN_WRITE(WritesMaterials, materials)
CAN_WRITE(WritesLights, lights)
CAN_WRITE(WritesMedia, media)
CAN_WRITE(WritesCurves, curves)
CAN_WRITE(WritesPupils, pupils)

static_assert(WritesShapes<GeometryPacking> && WritesShapes<ShapePacking>);
static_assert(!WritesShapes<LightPacking> && !WritesShapes<AreaElement> && !WritesShapes<MaterialPacking> && !WritesShapes<MediumPacking>);
static_assert(WritesMaterials<MaterialPacking> && !WritesMaterials<GeometryPacking> && !WritesMaterials<LightPacking>);
static_assert(WritesLights<LightPacking> && !WritesLights<GeometryPacking> && !WritesLights<ShapePacking> && !WritesLights<MediumPacking>);
static_assert(WritesMedia<MediumPacking> && !WritesMedia<MaterialPacking> && !WritesMedia<LightPacking>);
static_assert(WritesPupils<CameraPacking> && !WritesPupils<MediumPacking> && !WritesPupils<LightPacking>);
static_assert(!WritesCurves<LightPacking> && !WritesCurves<MediumPacking> && !WritesCurves<MaterialPacking>);

}  // namespace
}  // namespace eikonal
