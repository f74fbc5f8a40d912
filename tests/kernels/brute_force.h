#pragma once
// Where rays meet a packed scene, in double precision, every element tested against every ray: what traversal is compared with.

#include "pack/tables.h"

#include <glm/glm.hpp>

#include <vector>

namespace eikonal {

/// The centre of a sphere, disk or cylinder, in the space of its BVH.
vec3 placedCenter(const object_space& q);

/// One element that a ray meets, or passes closely.
struct Candidate {
    double t;
    uint element, instance;
    double margin;      ///< how far inside of its element, as a fraction of its size; < 0: just outside
    double tolerance;   ///< by which t may differ in single precision
};

class BruteForce {
public:
    explicit BruteForce(const PackedScene& scene);

    /// All with margin > -1; those above -slack may count as hits, those above slack must.
    std::vector<Candidate> meet(vec3 o, vec3 d) const;
    /// Elements of the world and of all objects, as the hierarchy holds them.
    size_t elements() const { return elements_; }

    static constexpr double slack = 1e-4;

private:
    struct Group { std::vector<uint> elements; };
    void collect(uint node, Group& group, std::vector<uint>* instances);
    void meetGroup(const Group& group, uint instance, glm::dvec3 o, glm::dvec3 d, std::vector<Candidate>& found) const;
    void meetElement(uint element, uint instance, glm::dvec3 o, glm::dvec3 d, std::vector<Candidate>& found) const;
    const PackedScene& scene_;
    Group world_;
    std::vector<uint> placed_;       ///< instances in the world
    std::vector<Group> objects_;     ///< by instance
    size_t elements_ = 0;
};

/// Whether the answer of a traversal (element NONE: nothing) is right; a message if not.
std::string judgeHit(const std::vector<Candidate>& all, uint element, uint instance, double t);
/// Whether a shadow ray of length tMax is blocked.
std::string judgeShadow(const std::vector<Candidate>& all, double tMax, bool blocked);

}  // namespace eikonal
