#include "film/join_sums.h"

#include "eikonal/film.h"
#include "film/join_mattes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <stdexcept>

namespace eikonal {
namespace {

/// The fields of FILM_FIELDS by how they are added. What is missing here belongs to the error estimate.
constexpr std::pair<const char*, const char*> compensatedFields[] = {{"sum", "compensation"},
                                                                     {"weight", "weight_excess"},
                                                                     {"emission", "emission_compensation"},
                                                                     {"direct", "direct_compensation"},
                                                                     {"indirect", "indirect_compensation"},
                                                                     {"volume", "volume_compensation"},
                                                                     {"albedo", "albedo_compensation"},
                                                                     {"position", "position_compensation"},
                                                                     {"uv", "uv_compensation"},
                                                                     {"opening", "opening_compensation"},
                                                                     {"closing", "closing_compensation"},
                                                                     {"distance", "distance_compensation"}};
constexpr const char* plainFields[] = {"normal", "ng", "seen"};
constexpr const char* countFields[] = {"count", "invalid"};
constexpr std::pair<const char*, const char*> voteFields[] = {{"object", "object_lead"}, {"material", "material_lead"}};
constexpr const char* noiseFields[] = {"square_weight", "mean",     "spread",      "quarter0",       "quarter1",
                                       "quarter2",      "quarter3", "weight0",     "weight1",        "weight2",
                                       "weight3",       "low_mean", "half_square", "quarter_square", "eighth_square"};
constexpr int quarters = 4;

double value(uint word) { return std::bit_cast<float>(word); }
uint asWord(double value) { return std::bit_cast<uint>(static_cast<float>(value)); }
uint clampedSum(double value) { return asWord(std::clamp(value, -double(MOST_SUM), double(MOST_SUM))); }

/// Distances are clamped to this; their squares are finite.
constexpr double mostDistance = 1e18;

}  // namespace

JoinedSums::JoinedSums(const QueueLayout& layout) : words_(static_cast<std::size_t>(layout.words)) {
    std::set<std::string> known(std::begin(noiseFields), std::end(noiseFields));
    const auto slot = [&](const char* name) { return layout.field(name).slot; };
    const auto words = [&](const char* name) { known.insert(name); return layout.field(name).words; };
    for (const auto& [sum, error] : compensatedFields) {
        words(error);
        for (int word = 0; word < words(sum); ++word) compensated_.push_back({slot(sum) + word, slot(error) + word});
    }
    for (const char* name : plainFields)
        for (int word = 0; word < words(name); ++word) plain_.push_back(slot(name) + word);
    for (const char* name : countFields) { words(name); counts_.push_back(slot(name)); }
    for (const auto& [id, lead] : voteFields) {
        words(lead);
        if (words(id)) votes_.push_back({slot(id), slot(lead)});
    }
    for (const FieldLayout& field : layout.fields)
        if (field.name == "buckets") {
            known.insert(field.name);
            for (int word = 0; word < field.words; word += BUCKET_WORDS) compensated_.push_back({field.slot + word, field.slot + word + 1});
        } else if (field.name == "groups" || field.name == "bands") {
            known.insert(field.name);
            for (int group = 0; group < field.words; group += GROUP_WORDS)
                for (int c = 0; c < WORDS_rgb; ++c)
                    compensated_.push_back({field.slot + group + c, field.slot + group + WORDS_rgb + c});
        } else if (field.name == "object_mattes" || field.name == "material_mattes") mattes_.push_back(field.slot);
        else if (!known.contains(field.name))
            throw std::logic_error("a film's field " + field.name + " cannot be joined");
    weight_ = slot("weight");
    squareWeight_ = slot("square_weight");
    mean_ = slot("mean");
    spread_ = slot("spread");
    quarter_ = slot("quarter0");
    quarterWeight_ = layout.field("weight0").words > 0 ? slot("weight0") : -1;
    lowMean_ = slot("low_mean");
    half_ = slot("half_square");
    quarterSquare_ = slot("quarter_square");
    eighth_ = slot("eighth_square");
}

void JoinedSums::join(PixelRow<const uint> earlier, SampleRange earlierRange, PixelRow<uint> row, SampleRange range,
                      std::size_t count) const {
    const auto before = [&](int word) { return earlier.first + static_cast<std::size_t>(word) * earlier.stride; };
    const auto now = [&](int word) { return row.first + static_cast<std::size_t>(word) * row.stride; };
    /* The error estimate needs the sums as they were */
    joinLuminances(before, now, count);
    if (joins(earlierRange, range)) joinQuarters(before, now, earlierRange.length(), range.length(), count);

    for (const auto& [sum, error] : compensated_) {
        const uint *sum1 = before(sum), *error1 = before(error);
        uint *sum2 = now(sum), *error2 = now(error);
        for (std::size_t i = 0; i < count; ++i) {
            const double exact = (value(sum1[i]) - value(error1[i])) + (value(sum2[i]) - value(error2[i]));
            sum2[i] = clampedSum(exact);
            error2[i] = asWord(value(sum2[i]) - exact);
        }
    }
    for (const int word : plain_)
        for (std::size_t i = 0; i < count; ++i) now(word)[i] = asWord(value(before(word)[i]) + value(now(word)[i]));
    for (const int word : counts_)
        for (std::size_t i = 0; i < count; ++i) now(word)[i] += before(word)[i];
    /* If one id has a majority in all samples, it has one in a range, and a larger lead than the other's (Misra and Gries 1982) */
    for (const auto& [id, lead] : votes_)
        for (std::size_t i = 0; i < count; ++i) {
            const uint id1 = before(id)[i], lead1 = before(lead)[i];
            uint &id2 = now(id)[i], &lead2 = now(lead)[i];
            const bool isSame = id1 == id2, isLess = lead2 > lead1;
            lead2 = isSame ? lead1 + lead2 : isLess ? lead2 - lead1 : lead1 - lead2;
            id2 = isSame || isLess ? id2 : id1;
        }

    for (const int slot : mattes_) joinMattes(earlier, row, slot, count);

    /* The error is estimated from 2^k samples: the first ones, or, of samples that are no siblings, those of the longer range */
    const unsigned length = earlierRange.length(), more = range.length();
    if (!joins(earlierRange, range)) {
        if (length >= more) keepEstimate(before, now, count);
    } else if (std::has_single_bit(length + more)) {
        for (std::size_t i = 0; i < count; ++i) estimate(before, now, i);
    } else keepEstimate(before, now, count);
}

/// The mean and the spread of two sets (Chan, Golub and LeVeque 1979).
template <class Before, class Now> void JoinedSums::joinLuminances(Before before, Now now, std::size_t count) const {
    const uint *weight1 = before(squareWeight_), *mean1 = before(mean_), *spread1 = before(spread_);
    uint *weight2 = now(squareWeight_), *mean2 = now(mean_), *spread2 = now(spread_);
    for (std::size_t i = 0; i < count; ++i) {
        const double a = value(weight1[i]), b = value(weight2[i]), share = a + b > 0 ? b / (a + b) : 0;
        const double apart = value(mean2[i]) - value(mean1[i]), near = std::clamp(apart, -mostDistance, mostDistance);
        spread2[i] = asWord(std::min(value(spread1[i]) + value(spread2[i]) + near * near * a * share, double(MOST_SPREAD)));
        mean2[i] = asWord(value(mean1[i]) + apart * share);
        weight2[i] = asWord(a + b);
    }
}

/// Adds the quarters of `more` samples to those of the `length` samples before them.
template <class Before, class Now>
void JoinedSums::joinQuarters(Before before, Now now, unsigned length, unsigned more, std::size_t count) const {
    const unsigned size = std::bit_floor(length) / 2;   // of a quarter
    for (const int first : {quarter_, quarterWeight_}) {
        if (first < 0) continue;
        const uint* q1[] = {before(first), before(first + 1), before(first + 2), before(first + 3)};
        uint* q2[] = {now(first), now(first + 1), now(first + 2), now(first + 3)};
        for (std::size_t i = 0; i < count; ++i) {
            double q[quarters] = {value(q1[0][i]), value(q1[1][i]), value(q1[2][i]), value(q1[3][i])};
            const double early = value(q2[0][i]) + value(q2[1][i]), late = value(q2[2][i]) + value(q2[3][i]);
            if (std::has_single_bit(length)) {   // four full quarters become two
                q[0] += q[1];
                q[1] = q[2] + q[3];
                q[2] = q[3] = 0;
            }
            if (more == 2 * size) {
                q[2] += early;
                q[3] += late;
            } else q[length / size] += early + late;
            for (int k = 0; k < quarters; ++k) q2[k][i] = clampedSum(q[k]);
        }
    }
}

template <class Before, class Now> void JoinedSums::keepEstimate(Before before, Now now, std::size_t count) const {
    for (const int word : {lowMean_, half_, quarterSquare_, eighth_}) std::copy_n(before(word), count, now(word));
}

/// As note_squares of kernels/film/quarters.clh, from the joined quarters of pixel i.
template <class Before, class Now> void JoinedSums::estimate(Before before, Now now, std::size_t i) const {
    const double weight = value(now(weight_)[i]);
    if (weight == 0) {
        for (const int word : {lowMean_, half_, quarterSquare_, eighth_}) now(word)[i] = before(word)[i];
        return;
    }
    double mean = 0, e[quarters], w[quarters];
    for (int k = 0; k < quarters; ++k) {
        mean += value(now(quarter_ + k)[i]) / weight;
        w[k] = quarterWeight_ >= 0 ? value(now(quarterWeight_ + k)[i]) : weight / quarters;
    }
    for (int k = 0; k < quarters; ++k)
        e[k] = std::clamp((value(now(quarter_ + k)[i]) - w[k] * mean) / weight, -mostDistance, mostDistance);
    const auto high = std::max_element(e, e + quarters) - e;
    const double highWeight = w[high] / weight;
    const auto squared = [](double x) { return x * x; };
    now(lowMean_)[i] = highWeight < 1 ? asWord(mean - e[high] / (1 - highWeight)) : before(lowMean_)[i];
    now(eighth_)[i] = before(quarterSquare_)[i];
    now(half_)[i] = asWord(std::min(squared((e[0] + e[1]) - (e[2] + e[3])), double(MOST_SPREAD)));
    now(quarterSquare_)[i] = asWord(std::min(2 * (squared(e[0] - e[1]) + squared(e[2] - e[3])), double(MOST_SPREAD)));
}

void JoinedSums::joinAll(std::span<const SampleRange> nodes, std::span<const PixelRow<const uint>> rows, PixelRow<uint> total,
                         std::size_t count) const {
    /* From the last to the first: each is joined with all that follow it */
    for (std::size_t word = 0; word < words_; ++word)
        std::copy_n(rows.back().first + word * rows.back().stride, count, total.first + word * total.stride);
    SampleRange range = nodes.back();
    for (std::size_t node = nodes.size() - 1; node-- > 0;) {
        join(rows[node], nodes[node], total, range, count);
        range.first = nodes[node].first;
    }
}

}  // namespace eikonal
