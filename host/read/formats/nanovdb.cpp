#include "read/formats/nanovdb_data.h"

#include "read/formats/nanovdb.h"

#include "available_memory.h"
#include "read/formats/input_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <set>

namespace eikonal {
namespace {

using Tree = nanovdb::FloatTree;
using Upper = Tree::Node2;
using Lower = Tree::Node1;
using Leaf = Tree::Node0;

/// The most blocks, of 512 voxels each, within the bounds of a grid.
constexpr double mostBlocks = 1 << 28;

/// More bytes than these are no real grid if they are more than so many times what they are made of.
constexpr double alwaysFine = 64 << 20, mostTimes = 2000;

/// The header of a grid in the file.
struct Found { nanovdb::io::MetaData meta; nanovdb::io::Codec codec; };

/// Goes through the file's headers until `wanted` returns true for a name, and leaves the stream at the start of that grid's data.
bool findGrid(std::istream& file, const std::function<bool(const std::string&)>& wanted, Found& found) {
    file.seekg(0, std::ios::end);
    const auto end = static_cast<std::uint64_t>(file.tellg());
    file.seekg(0);
    for (std::uint64_t at = 0; at < end;) {
        nanovdb::io::Header header;
        file.seekg(static_cast<std::streamoff>(at));
        readRaw(file, &header, sizeof header);
        if (header.magic != NANOVDB_MAGIC_NUMBER) throw ReadProblem("is not a NanoVDB file");
        if (header.version.getMajor() != NANOVDB_MAJOR_VERSION_NUMBER)
            throw ReadProblem(
                fmt::format("has NanoVDB's file version {}; only {} can be read", header.version.getMajor(), NANOVDB_MAJOR_VERSION_NUMBER));

        /* All headers of a segment come before its data */
        std::vector<std::pair<nanovdb::io::MetaData, std::string>> grids;
        for (int i = 0; i < header.gridCount; ++i) {
            nanovdb::io::MetaData meta;
            readRaw(file, &meta, sizeof meta);
            if (meta.nameSize > end || meta.fileSize > end) throw ReadProblem("is damaged: a size in its header is beyond its end");
            std::string name(meta.nameSize, '\0');
            readRaw(file, name.data(), name.size());
            grids.emplace_back(meta, name.c_str());
        }
        at = static_cast<std::uint64_t>(file.tellg());
        for (const auto& [meta, name] : grids) {
            if (wanted(name)) {
                found = {meta, header.codec};
                file.seekg(static_cast<std::streamoff>(at));
                return true;
            }
            at += meta.fileSize;
        }
    }
    return false;
}

/// A node at an offset from another node; checks the offset, since a damaged file may contain any value.
template <class Node> const Node& nodeAt(const nanovdb::GridHandle<>& handle, const void* from, std::int64_t offset) {
    const std::int64_t size = static_cast<std::int64_t>(handle.size()), here = static_cast<const std::uint8_t*>(from) - handle.data();
    const std::int64_t at = std::clamp(offset, -size - 1, size + 1) + here;
    if (at < 0 || at > size - static_cast<std::int64_t>(sizeof(Node)) || at % NANOVDB_DATA_ALIGNMENT)
        throw ReadProblem("is damaged: a node lies outside the file");
    return *reinterpret_cast<const Node*>(handle.data() + at);
}

/// Copies a tree's values block by block.
class Copy {
public:
    /// fileSize: of the grid in the file, compressed.
    Copy(const nanovdb::GridHandle<>& handle, std::uint64_t fileSize)
        : handle_(handle), mostValueBytes_(std::max(alwaysFine, mostTimes * static_cast<double>(fileSize))) {
        const auto& grid = nodeAt<nanovdb::GridData>(handle_, handle_.data(), 0);
        const auto& tree = nodeAt<nanovdb::TreeData<3>>(handle_, &grid, sizeof(nanovdb::GridData));
        const auto& root = nodeAt<Tree::RootType::DataType>(handle_, &tree, tree.mNodeOffset[3]);
        countNode(sizeof(nanovdb::GridData) + sizeof tree + sizeof root);
        setBounds(root.mBBox, root.mBackground);
        setMap(grid.mMap);

        nodeAt<Tree::RootType::DataType::Tile>(
            handle_, &root,
            static_cast<std::int64_t>(sizeof root + (root.mTableSize - std::int64_t(1)) * std::int64_t(sizeof(*root.tile(0)))));
        std::set<std::array<int, 3>> origins;
        for (std::uint32_t i = 0; i < root.mTableSize; ++i) {
            const auto& tile = *root.tile(i);
            countNode(sizeof tile);
            const glm::ivec3 origin(tile.origin()[0], tile.origin()[1], tile.origin()[2]);
            if (!origins.insert({origin.x, origin.y, origin.z}).second) throw ReadProblem("is damaged: two of its nodes are in one place");
            if (!tile.isChild()) fill(origin, Upper::DIM, tile.value);
            else copyInternal<Upper, Lower>(nodeAt<Upper::DataType>(handle_, &root, tile.child), origin);
        }
    }
    SparseGrid result() { return std::move(grid_); }

private:
    /// Nodes lie side by side. If they were shared, a small file could hold a tree of any size.
    void countNode(size_t bytes) {
        nodeBytes_ += bytes;
        if (nodeBytes_ > handle_.size()) throw ReadProblem("is damaged: its nodes take more than the whole file");
    }

    void setBounds(const nanovdb::CoordBBox& box, float background) {
        for (int a = 0; a < 3; ++a) {
            grid_.low[a] = box.min()[a];
            grid_.high[a] = box.max()[a];
        }
        if (glm::any(glm::lessThan(grid_.high, grid_.low))) grid_.low = grid_.high = glm::ivec3(0);   // no active voxel
        grid_.firstBlock = grid_.low >> 3;
        const glm::dvec3 blocks = glm::dvec3(grid_.high >> 3) - glm::dvec3(grid_.firstBlock) + 1.;
        if (blocks.x * blocks.y * blocks.z > mostBlocks)
            throw ReadProblem(
                fmt::format("has a grid of {:.3g} blocks; at most {:.3g} can be read", blocks.x * blocks.y * blocks.z, mostBlocks));
        const double bytes = blocks.x * blocks.y * blocks.z * sizeof(std::uint32_t);
        if (bytes > std::max(alwaysFine, mostTimes * static_cast<double>(handle_.size())))
            throw ReadProblem(fmt::format("is damaged: nodes of {} bytes cannot hold a grid of {:.3g} blocks", handle_.size(),
                                          blocks.x * blocks.y * blocks.z));
        if (bytes > static_cast<double>(availableMemory()) / 2)
            throw ReadProblem(fmt::format("has a grid of {:.3g} blocks, which does not fit into memory", blocks.x * blocks.y * blocks.z));
        grid_.blocks = blocks;
        grid_.blockOf.assign(static_cast<size_t>(grid_.blocks.x) * grid_.blocks.y * grid_.blocks.z, constantBlock(background));
    }

    void setMap(const nanovdb::Map& map) {
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) {
                grid_.voxelFromMedium[column][row] = map.mInvMatD[3 * row + column];
                grid_.voxelFromMedium[3][row] -= map.mInvMatD[3 * row + column] * map.mVecD[column];
            }
        const double volume = glm::determinant(glm::dmat3(grid_.voxelFromMedium));
        if (!std::isfinite(volume) || volume == 0) throw ReadProblem("is damaged: its voxels have no volume");
    }

    template <class Node, class Child> void copyInternal(const typename Node::DataType& node, glm::ivec3 origin) {
        countNode(sizeof node);
        constexpr int log2 = Node::LOG2DIM, side = 1 << log2;
        for (int n = 0; n < side * side * side; ++n) {
            const glm::ivec3 at = origin + glm::ivec3(n >> (2 * log2), (n >> log2) & (side - 1), n & (side - 1)) * int(Child::DIM);
            if (!node.mChildMask.isOn(n)) fill(at, Child::DIM, node.mTable[n].value);
            else if constexpr (std::is_same_v<Child, Leaf>) copyLeaf(nodeAt<Leaf::DataType>(handle_, &node, node.mTable[n].child), at);
            else copyInternal<Child, Leaf>(nodeAt<typename Child::DataType>(handle_, &node, node.mTable[n].child), at);
        }
    }

    void copyLeaf(const Leaf::DataType& leaf, glm::ivec3 origin) {
        countNode(sizeof leaf);
        std::uint32_t* block = blockAt(origin >> 3);
        if (!block) return;
        *block = newBlock();
        for (int z = 0; z < 8; ++z)
            for (int y = 0; y < 8; ++y)
                for (int x = 0; x < 8; ++x) grid_.values.push_back(checked(leaf.mValues[(x * 8 + y) * 8 + z]));
    }

    /// Fills a cube with one value.
    void fill(glm::ivec3 origin, int side, float value) {
        const glm::ivec3 low = glm::max(origin >> 3, grid_.firstBlock),
                         high = glm::min((origin >> 3) + side / 8, grid_.firstBlock + grid_.blocks);
        if (glm::any(glm::greaterThanEqual(low, high))) return;
        const std::uint32_t constant = constantBlock(value);
        for (int z = low.z; z < high.z; ++z)
            for (int y = low.y; y < high.y; ++y)
                for (int x = low.x; x < high.x; ++x) *blockAt({x, y, z}) = constant;
    }

    std::uint32_t* blockAt(glm::ivec3 block) {
        const glm::ivec3 at = block - grid_.firstBlock;
        if (glm::any(glm::lessThan(at, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(at, grid_.blocks))) return nullptr;
        return &grid_.blockOf[(static_cast<size_t>(at.z) * grid_.blocks.y + at.y) * grid_.blocks.x + at.x];
    }

    std::uint32_t constantBlock(float value) {
        value = checked(value);
        if (value == 0) return SparseGrid::empty;
        const auto [place, isNew] = constants_.try_emplace(value, newBlock());
        if (isNew) grid_.values.insert(grid_.values.end(), 512, value);
        return place->second;
    }

    /// The number of a block whose values are appended next.
    std::uint32_t newBlock() const {
        if (static_cast<double>(grid_.values.size() * sizeof(float)) > mostValueBytes_)
            throw ReadProblem("is damaged: it is too small for the blocks that it describes");
        return static_cast<std::uint32_t>(grid_.values.size() / 512);
    }

    static float checked(float value) {
        if (!std::isfinite(value)) throw ReadProblem("has a value that is not finite");
        return std::max(value, 0.f);
    }

    const nanovdb::GridHandle<>& handle_;
    SparseGrid grid_;
    std::map<float, std::uint32_t> constants_;
    size_t nodeBytes_ = 0;
    double mostValueBytes_;
};

std::ifstream open(const std::string& path) {
    noteInputFile(path);
    std::ifstream file(path, std::ios::binary);
    if (!file) throw ReadProblem(std::string("cannot be opened: ") + std::strerror(errno));
    return file;
}

}  // namespace

std::vector<std::string> gridNames(const std::string& path) {
    std::ifstream file = open(path);
    std::vector<std::string> names;
    Found found;
    findGrid(file, [&](const std::string& name) { names.push_back(name); return false; }, found);
    return names;
}

std::shared_ptr<const SparseGrid> readNanoVdb(const std::string& path, const std::string& name) {
    std::ifstream file = open(path);
    Found found;
    if (!findGrid(file, [&](const std::string& other) { return other == name; }, found)) return nullptr;
    if (found.meta.gridType != nanovdb::GridType::Float)
        throw ReadProblem(
            fmt::format("has a grid \"{}\" of {}; only grids of floats can be read", name,
                        found.meta.gridType < nanovdb::GridType::End ? nanovdb::toStr(found.meta.gridType) : "an unknown type"));
    if (found.meta.gridClass == nanovdb::GridClass::LevelSet)
        throw ReadProblem(fmt::format("has a grid \"{}\" that is a level set; only fog volumes are rendered", name));
    try {
        const nanovdb::GridHandle<> handle = readGrid(file, found.meta, found.codec);
        return std::make_shared<const SparseGrid>(Copy(handle, found.meta.fileSize).result());
    } catch (const ReadProblem&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw ReadProblem("has a grid that does not fit into memory");
    } catch (const std::exception& e) {
        throw ReadProblem(std::string("cannot be read: ") + e.what());
    }
}

}  // namespace eikonal
