#include "read/pbrt/lens_file.h"

#include "read/pbrt/source.h"
#include "read/pbrt/tokens.h"

namespace eikonal::pbrt {

std::vector<LensElement> readLensFile(const std::string& path) {
    TokenStream tokens;
    tokens.push(path, readTextFile(path));
    std::vector<LensElement> lens;
    for (Token token = tokens.next(); token.kind != Token::Kind::end; token = tokens.next()) {
        const SourceLocation where = tokens.locate(token);
        double numbers[4] = {};
        for (int i = 0; i < 4; ++i) {
            if (i > 0) token = tokens.next();
            if (token.kind == Token::Kind::end)
                throw SceneError(where, "the last element of this lens has " + std::to_string(i) +
                                            " numbers; four are expected: radius of curvature, "
                                            "thickness, index of refraction, diameter of the aperture");
            numbers[i] = tokens.toNumber<double>(token, "a number");
        }
        const LensElement element{numbers[0], numbers[1], numbers[2], numbers[3]};
        if (!(element.apertureDiameter > 0))
            throw SceneError(where, "an element of this lens has an aperture of " + std::to_string(element.apertureDiameter) +
                                        " mm; it must be above 0");
        if (element.eta < 0) throw SceneError(where, "an element of this lens has an index of refraction below 0");
        lens.push_back(element);
    }
    if (lens.empty()) throw SceneError({std::make_shared<const std::string>(path)}, "this lens file has no numbers");
    return lens;
}

}  // namespace eikonal::pbrt
