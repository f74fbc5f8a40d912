#include "kinds/shape_kind.h"

#include "kind_features.h"
namespace eikonal {

std::span<const ShapeKind> shapeKindList() {
    static const ShapeKind entries[] = {
#define ADD_ENTRY(name, FEATURE, SPACE) {#name, shape_##name, KindFeature::FEATURE, name##_shape},
        SHAPES(ADD_ENTRY)
#undef ADD_ENTRY
    };
    return entries;
}

static Shape meshOf(shape_kind kind, std::shared_ptr<const Mesh> mesh) {
    Shape s;
    s.kind = &kindOf(kind);
    s.mesh = std::move(mesh);
    return s;
}

Shape triangleMesh(std::shared_ptr<const Mesh> mesh) { return meshOf(shape_triangle, std::move(mesh)); }
Shape bilinearMesh(std::shared_ptr<const Mesh> mesh) { return meshOf(shape_bilinear, std::move(mesh)); }

}  // namespace eikonal
