#include "stage_fixture.h"

#include <cmath>

namespace eikonal {

static const char* const everything = R"(
    LookAt 0 1 -9  0 0.5 0  0 1 0
    Camera "perspective" "float fov" 40 "float lensradius" 0.05 "float focaldistance" 9
    Film "rgb" "integer xresolution" 16 "integer yresolution" 16
    PixelFilter "gaussian" "float xradius" 1.5 "float yradius" 1.5
    Sampler "sobol" "integer pixelsamples" 4
    Integrator "path" "integer maxdepth" 5
    WorldBegin
    LightSource "infinite" "rgb L" [ 0.5 0.25 1 ]
    LightSource "point" "rgb I" [ 3 3 3 ] "point3 from" [ 0 4 -2 ]
    AttributeBegin
        AreaLightSource "diffuse" "rgb L" [ 4 3 2 ] "bool twosided" true
        Translate 0 2.2 0
        Shape "disk" "float radius" 0.9
    AttributeEnd
    AttributeBegin
        AreaLightSource "diffuse" "rgb L" [ 2 3 4 ]
        Shape "trianglemesh" "integer indices" [ 0 1 2 ] "point3 P" [ -4 -1 2  0 4 3  -4 3 2 ]
    AttributeEnd
    Texture "checks" "spectrum" "checkerboard" "float uscale" 8 "float vscale" 8 "rgb tex1" [ 0.7 0.1 0.1 ] "rgb tex2" [ 0.1 0.7 0.1 ]
    Texture "bumps" "float" "checkerboard" "float uscale" 20 "float vscale" 20 "float tex1" 0.01 "float tex2" 0
    Material "diffuse" "texture reflectance" "checks" "texture displacement" "bumps"
    Shape "bilinearmesh" "point3 P" [ -20 -1 -20  20 -1 -20  -20 -1 20  20 -1 20 ]
    AttributeBegin Translate -3 0 0 Material "conductor" "float uroughness" 0.1 "float vroughness" 0.4 Shape "sphere" "float radius" 0.6
        AttributeEnd
    AttributeBegin Translate -1.8 0 0 Material "conductor" "float roughness" 0 Shape "sphere" "float radius" 0.6 AttributeEnd
    AttributeBegin Translate -0.6 0 0 Material "dielectric" "float roughness" 0.3 Shape "sphere" "float radius" 0.6 AttributeEnd
    AttributeBegin Translate 0.6 0 0 Material "dielectric" Shape "sphere" "float radius" 0.6 AttributeEnd
    AttributeBegin Translate 1.8 0 0 Material "thindielectric" Shape "sphere" "float radius" 0.6 AttributeEnd
    AttributeBegin Translate 3 0 0 Material "diffusetransmission" Shape "sphere" "float radius" 0.6 "float zmin" -0.4 "float alpha" 0.8
        AttributeEnd
    MakeNamedMaterial "red" "string type" "diffuse" "rgb reflectance" [ 0.8 0.1 0.1 ]
    MakeNamedMaterial "glass" "string type" "dielectric"
    AttributeBegin
        Material "mix" "string materials" [ "red" "glass" ] "float amount" 0.4
        ObjectBegin "ball" Shape "sphere" "float radius" 0.4 ObjectEnd
        AttributeBegin Translate -1.2 1.3 0 ObjectInstance "ball" AttributeEnd
        AttributeBegin Translate 1.2 1.3 0 ObjectInstance "ball" AttributeEnd
    AttributeEnd)";

const PackedScene& sceneOfEverything() {
    static const PackedScene packed = [] {
        PackedScene s = packText(everything);
        s.require(Feature::AOVS, "the test");
        return s;
    }();
    return packed;
}

void expectClean(const QueueWords& q, size_t i, int words) {
    for (const FieldLayout& f : q.layout().fields)
        for (int w = 0; w < f.words; ++w)
            ASSERT_NE(q.word(f.slot + w, i), poison) << "queue " << q.layout().name << " item " << i << " field " << f.name;
    for (int w = q.layout().fields.back().slot + q.layout().fields.back().words; w < words; ++w)
        ASSERT_NE(q.word(w, i), poison) << "item " << i << " parameter word " << w;
}

double lengthOf(vec3 v) {
    return std::sqrt(static_cast<double>(v.x) * v.x + static_cast<double>(v.y) * v.y + static_cast<double>(v.z) * v.z);
}

}  // namespace eikonal
