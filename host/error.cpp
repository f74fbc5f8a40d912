#include "error.h"

#include "printable.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace eikonal {

std::string SourceLocation::toString() const {
    if (!file) return {};
    std::string text = *file;
    if (line > 0) text += ":" + std::to_string(line);
    if (line > 0 && column > 0) text += ":" + std::to_string(column);
    return text;
}

static std::string locate(const SourceLocation& where, const std::string& message) {
    const std::string place = where.toString();
    return place.empty() ? message : inOneLine(place + ": " + message);
}

SceneError::SceneError(const SourceLocation& where, const std::string& message)
    : Error(ExitCode::scene, locate(where, message)), hasPlace(where.file != nullptr) {}

int editDistance(const std::string& a, const std::string& b) {
    std::vector<int> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (size_t i = 1; i <= a.size(); ++i) {
        int diagonal = row[0];
        row[0] = static_cast<int>(i);
        for (size_t j = 1; j <= b.size(); ++j) {
            const int substitute = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            row[j] = std::min({substitute, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row[b.size()];
}

}  // namespace eikonal
