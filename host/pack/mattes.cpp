#include "pack/mattes.h"

#include "eikonal/film.h"
#include "image/cryptomatte.h"
#include "kinds/material_kind.h"
#include "kinds/shape_kind.h"

#include <fmt/format.h>

#include <filesystem>

namespace eikonal {
namespace {

/// A name that is there, or one of the kind and place of a thing without, which is the same on every machine.
std::string nameOf(const std::string& own, const char* kind, const SourceLocation& where) {
    if (!own.empty() || !where.file) return own.empty() ? kind : own;
    return fmt::format("{}@{}:{}", kind, std::filesystem::path(*where.file).filename().string(), where.line);
}

/// A table of IDs, and the names that they stand for.
class MatteTable {
public:
    explicit MatteTable(Table<uint>& table) : table_(table) { table_.push_back(NO_SURFACE_ID); }
    void add(const std::string& name) {
        const std::string valid = cryptomatteName(name);
        const auto [place, isNew] = ids_.try_emplace(valid);
        if (isNew) place->second = cryptomatteId(valid);
        table_.push_back(place->second);
    }
    std::string manifest() const { return cryptomatteManifest(ids_); }

private:
    Table<uint>& table_;
    CryptomatteIds ids_;
};

}  // namespace

void packMattes(const Scene& scene, PackedScene& packed) {
    if (packed.features.has(Feature::CRYPTO_OBJECT)) {
        MatteTable objects(packed.tables.object_matte_ids);
        for (const Shape& s : scene.shapes) {
            const ShapeKind& kind = *s.kind;
            objects.add(nameOf(s.name, kind.name, s.where));
        }
        for (const Instance& i : scene.instances) objects.add(scene.objects[static_cast<size_t>(i.object)].name);
        packed.objectManifest = objects.manifest();
    }
    if (packed.features.has(Feature::CRYPTO_MATERIAL)) {
        MatteTable materials(packed.tables.material_matte_ids);
        for (const int source : packed.materialSources) {
            if (source == none) { materials.add("default"); continue; }
            const Material& m = scene.materials[static_cast<size_t>(source)];
            const MaterialKind& kind = *m.kind;
            materials.add(nameOf(m.name, kind.directives.front().name, m.where));
        }
        packed.materialManifest = materials.manifest();
    }
}

}  // namespace eikonal
