#include "read/pbrt/directives.h"

#include "read/pbrt/lights.h"
#include "read/pbrt/parser.h"
#include "read/pbrt/version3.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <unordered_map>

namespace eikonal::pbrt {
namespace {

using Where = const SourceLocation&;

/// Calls f and notes its errors; they do not concern the grammar, so reading continues.
template <class F> void note(Builder& builder, F&& f) { builder.reading.problems.guard(std::forward<F>(f)); }

/// Reads the name and parameters of a directive, calls f(name, parameters), and notes its errors. If an included file with parameters was
/// missing, does not report errors that may follow from that.
template <class F> void withParameters(Parser& parser, Builder& builder, const char* what, F&& f) {
    const std::string name = parser.quoted(what);
    ParameterList parameters = parser.parameters();
    note(builder, [&] {
        try {
            f(name, std::move(parameters));
        } catch (const Version3Error&) { throw; } catch (const SceneError&) {
            if (!parser.hasLostParameters()) throw;
        }
    });
}

template <Settings::Sort sort> void setting(Parser& p, Builder& b, Where where) {
    withParameters(p, b, "a type", [&](const std::string& type, ParameterList parameters) {
        b.settings.set(sort, type, b.state, std::move(parameters), where);
        if (sort == Settings::Sort::camera) b.nameCameraSystem();
    });
}

void activeTransform(Parser& p, Builder& b, Where) {
    const std::string which = p.word();
    if (which != "All" && which != "StartTime" && which != "EndTime")
        throw SceneError(p.lastPlace(), "\"" + which + "\" found where All, StartTime or EndTime is expected");
    b.state.active = {which != "EndTime", which != "StartTime"};
}

void colorSpace(Parser& p, Builder& b, Where) {
    const std::string name = p.quoted("the name of a colour space");
    const auto space = colorSpaceNamed(name);
    if (space) b.state.space = *space;
    else
        b.reading.problems.add(p.lastPlace(),
                               "there is no colour space \"" + name + "\"; it can be \"srgb\", \"dci-p3\", \"rec2020\" or \"aces2065-1\"");
}

void option(Parser& p, Builder& b, Where) {
    const std::string name = p.quoted("the name of an option");
    const SourceLocation where = p.lastPlace();
    const std::string value = p.word();
    note(b, [&] { b.settings.setOption(name, value, b.inWorld, where, p.lastPlace()); });
}

void texture(Parser& p, Builder& b, Where where) {
    const std::string name = p.quoted("the name of a texture"), type = p.quoted("\"float\" or \"spectrum\"");
    if (type == "color") throw Version3Error(p.lastPlace(), "a texture of type \"color\"", "\"spectrum\"");
    if (type != "float" && type != "spectrum")
        throw SceneError(p.lastPlace(), "\"" + type + "\" found where \"float\" or \"spectrum\" is expected");
    withParameters(p, b, "a kind of texture", [&](const std::string& kind, ParameterList parameters) {
        b.textures.define(name, type == "float", kind, b.state, std::move(parameters), where);
    });
}

void areaLightSource(Parser& p, Builder& b, Where where) {
    withParameters(p, b, "a type", [&](const std::string& kind, ParameterList parameters) {
        b.state.areaLight = addAreaLight(b.reading, b.textures, kind, b.state, std::move(parameters), where);
    });
}

void material(Parser& p, Builder& b, Where where) {
    withParameters(p, b, "a type", [&](const std::string& kind, ParameterList parameters) {
        b.state.material = b.materials.define("", kind, b.state, std::move(parameters), where);
    });
}

void makeNamedMaterial(Parser& p, Builder& b, Where where) {
    withParameters(p, b, "the name of a material", [&](const std::string& name, ParameterList parameters) {
        const std::string kind = typeOf(parameters, "MakeNamedMaterial", where);
        b.materials.define(name, kind, b.state, std::move(parameters), where);
    });
}

void mediumInterface(Parser& p, Builder& b, Where) {
    const std::string inside = p.quoted("the name of a medium"), outside = p.quotedOr(inside);
    b.state.inside = b.media.numberOf(inside);
    b.state.outside = b.media.numberOf(outside);
}

void transformBegin(Parser&, Builder& b, Where where) {
    b.reading.diagnostics.infoOnce("TransformBegin", where, "TransformBegin is deprecated; AttributeBegin does the same");
    b.beginAttributes(where);
}

const Directive directives[] = {
    // Transforms.
    {"Identity", Place::anywhere, [](Parser&, Builder& b, Where) { b.setTransform(Transform(1)); }},
    {"Translate", Place::anywhere,
     [](Parser& p, Builder& b, Where) {
         const auto [x, y, z] = p.numbers<3>();
         b.concatenate(glm::translate(Transform(1), {x, y, z}));
     }},
    {"Scale", Place::anywhere,
     [](Parser& p, Builder& b, Where) {
         const auto [x, y, z] = p.numbers<3>();
         b.concatenate(glm::scale(Transform(1), {x, y, z}));
     }},
    {"Rotate", Place::anywhere,
     [](Parser& p, Builder& b, Where where) {
         const auto v = p.numbers<4>();
         note(b, [&] { b.rotate(v[0], {v[1], v[2], v[3]}, where); });
     }},
    {"LookAt", Place::anywhere,
     [](Parser& p, Builder& b, Where where) {
         const auto v = p.numbers<9>();
         note(b, [&] { b.lookAt({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, where); });
     }},
    {"Transform", Place::anywhere, [](Parser& p, Builder& b, Where) { b.setTransform(p.matrix()); }},
    {"ConcatTransform", Place::anywhere, [](Parser& p, Builder& b, Where) { b.concatenate(p.matrix()); }},
    {"CoordinateSystem", Place::anywhere, [](Parser& p, Builder& b, Where) { b.nameCoordinateSystem(p.quoted("a name")); }},
    {"CoordSysTransform", Place::anywhere, [](Parser& p, Builder& b, Where where) { b.useCoordinateSystem(p.quoted("a name"), where); }},
    {"ActiveTransform", Place::anywhere, activeTransform},
    {"TransformTimes", Place::options,
     [](Parser& p, Builder& b, Where where) {
         const auto [start, end] = p.numbers<2>();
         if (!(start < end))
             throw SceneError(where, fmt::format("TransformTimes are a start and an end after it, not {:g} and {:g}", start, end));
         b.reading.scene.motionStart = start;
         b.reading.scene.motionEnd = end;
     }},

    // Settings.
    {"Camera", Place::options, setting<Settings::Sort::camera>},
    {"Film", Place::options, setting<Settings::Sort::film>},
    {"PixelFilter", Place::options, setting<Settings::Sort::filter>},
    {"Sampler", Place::options, setting<Settings::Sort::sampler>},
    {"Integrator", Place::options, setting<Settings::Sort::integrator>},
    {"Accelerator", Place::options, setting<Settings::Sort::accelerator>},
    {"ColorSpace", Place::anywhere, colorSpace},
    {"Option", Place::anywhere, option},

    // Blocks.
    {"WorldBegin", Place::anywhere,
     [](Parser&, Builder& b, Where where) {
         if (b.inWorld) throw SceneError(where, "a second WorldBegin; a scene has one");
         b.beginWorld();
     }},
    {"AttributeBegin", Place::world, [](Parser&, Builder& b, Where where) { b.beginAttributes(where); }},
    {"AttributeEnd", Place::world, [](Parser&, Builder& b, Where where) { note(b, [&] { b.endAttributes(where); }); }},
    {"TransformBegin", Place::world, transformBegin},
    {"TransformEnd", Place::world, [](Parser&, Builder& b, Where where) { note(b, [&] { b.endAttributes(where); }); }},
    {"ObjectBegin", Place::world,
     [](Parser& p, Builder& b, Where where) {
         const std::string name = p.quoted("a name");
         note(b, [&] { b.beginObject(name, where); });
     }},
    {"ObjectEnd", Place::world, [](Parser&, Builder& b, Where where) { note(b, [&] { b.endObject(where); }); }},
    {"Import", Place::world, [](Parser& p, Builder&, Where where) { p.import(where); }},
    {"Attribute", Place::anywhere,
     [](Parser& p, Builder& b, Where where) {
         withParameters(p, b, "a target", [&](const std::string& target, ParameterList parameters) {
             b.addAttributes(target, std::move(parameters), where);
         });
     }},

    // What the world is made of.
    {"Shape", Place::world,
     [](Parser& p, Builder& b, Where where) {
         withParameters(p, b, "a type", [&](const std::string& kind, ParameterList parameters) {
             b.shapes.add(kind, b.state, std::move(parameters), where);
         });
     }},
    {"ObjectInstance", Place::world,
     [](Parser& p, Builder& b, Where where) {
         const std::string name = p.quoted("the name of an object");
         note(b, [&] { b.shapes.addInstance(name, b.state, where); });
     }},
    {"ReverseOrientation", Place::world, [](Parser&, Builder& b, Where) { b.state.reverseOrientation = !b.state.reverseOrientation; }},
    {"Material", Place::world, material},
    {"MakeNamedMaterial", Place::world, makeNamedMaterial},
    {"NamedMaterial", Place::world,
     [](Parser& p, Builder& b, Where) { b.state.material = b.materials.numberOf(p.quoted("the name of a material")); }},
    {"Texture", Place::world, texture},
    {"LightSource", Place::world,
     [](Parser& p, Builder& b, Where where) {
         withParameters(p, b, "a type", [&](const std::string& kind, ParameterList parameters) {
             addLight(b.reading, b.textures, kind, b.state, std::move(parameters), where);
         });
     }},
    {"AreaLightSource", Place::world, areaLightSource},
    {"MakeNamedMedium", Place::anywhere,
     [](Parser& p, Builder& b, Where where) {
         withParameters(p, b, "the name of a medium", [&](const std::string& name, ParameterList parameters) {
             b.media.define(name, b.state, std::move(parameters), where);
         });
     }},
    {"MediumInterface", Place::anywhere, mediumInterface},
};

}  // namespace

const Directive& findDirective(const Token& token, const SourceLocation& where) {
    static const auto byName = [] {
        std::unordered_map<std::string_view, const Directive*> map;
        for (const Directive& directive : directives) map[directive.name] = &directive;
        return map;
    }();
    const std::string text(token.text.substr(0, 60));
    if (token.kind == Token::Kind::word) {
        if (const auto found = byName.find(token.text); found != byName.end()) return *found->second;
        if (const auto successor = successorOf("directive", text)) throw Version3Error(where, "\"" + text + "\"", successor->c_str());
    }
    const std::string near = nearestWord(text, directiveNames());
    throw SceneError(where, quote(token) + " found where a directive is expected" +
                                (near.empty() ? ", such as Shape or Material" : "; did you mean \"" + near + "\"?"));
}

std::vector<std::string> directiveNames() {
    std::vector<std::string> names = {"Include"};
    for (const Directive& directive : directives) names.push_back(directive.name);
    return names;
}

}  // namespace eikonal::pbrt
