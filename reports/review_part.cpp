// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/review_part.h"

#include <QByteArray>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <type_traits>

#include "sim/core/as_index.h"

namespace placode::reports {
namespace {

using sim::as_index;

static_assert(std::endian::native == std::endian::little, "parts are little-endian");

constexpr uint8_t kOfMarkedTissue = 2;  // of a point of a line; 1: cut there
constexpr int kZlibLevel = 9;           // 6 makes places some 12 % larger.

template <class Value>
void put(std::string& to, const Value& value) {
    to.append(reinterpret_cast<const char*>(&value), sizeof value);
}

uint16_t step_of(float metres) {
    const double steps = (static_cast<double>(metres) - kReviewLeastM) / kReviewStepM;
    return static_cast<uint16_t>(std::clamp(std::lround(steps), 0L, 65535L));
}

std::array<uint16_t, 3> place_of(const std::array<float, 3>& metres) {
    return {step_of(metres[0]), step_of(metres[1]), step_of(metres[2])};
}

uint8_t share_of(float share) {
    return static_cast<uint8_t>(std::lround(255 * std::clamp(share, 0.0F, 1.0F)));
}

/// Numbers as all their low bytes, then the next ones: alike ones lie together.
template <class Value>
std::string in_planes(const std::vector<Value>& values, int planes) {
    std::string bytes;
    bytes.reserve(static_cast<size_t>(planes) * values.size());
    for (int plane = 0; plane < planes; ++plane)
        for (const Value value : values)
            bytes.push_back(static_cast<char>(value >> 8 * plane & 0xff));
    return bytes;
}

/// Small differences of both signs as small numbers: 0, -1, 1, -2, ...
template <class Value>
Value zigzag(Value now, Value before) {
    using Signed = std::make_signed_t<Value>;
    const auto change = static_cast<Signed>(static_cast<Value>(now - before));
    const auto sign = static_cast<Value>(change < 0 ? -1 : 0);
    return static_cast<Value>(static_cast<Value>(change) << 1 ^ sign);
}

bool moved(uint16_t now, uint16_t kept) {
    return std::abs(int{now} - int{kept}) > kReviewRestSteps;
}

/// Edits of surfaces: the first corner by its difference to the one of the edit before, the others
/// by theirs to the first, which is the lowest.
struct Corners {
    std::vector<uint32_t> first, second, third;
    uint32_t before = 0;

    void add(std::array<uint32_t, 3> corner) {
        std::rotate(corner.begin(), std::min_element(corner.begin(), corner.end()), corner.end());
        first.push_back(zigzag(corner[0], before));
        second.push_back(corner[1] - corner[0]);
        third.push_back(corner[2] - corner[0]);
        before = corner[0];
    }
    [[nodiscard]] std::string bytes() const {
        std::vector<uint32_t> all = first;
        all.insert(all.end(), second.begin(), second.end());
        all.insert(all.end(), third.begin(), third.end());
        return in_planes(all, 3);  // no body has 2^23 vertices
    }
};

bool same(const sim::SurfaceTriangle& a, const sim::SurfaceTriangle& b) {
    return a.vertex == b.vertex && a.tissue == b.tissue && a.fresh == b.fresh;
}

std::array<float, kReviewNeedleFloats> floats_of(const sim::Pose& pose) {
    const std::array<double, kReviewNeedleFloats> values{
        pose.p.x(), pose.p.y(), pose.p.z(), pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z()};
    std::array<float, kReviewNeedleFloats> floats{};
    std::transform(values.begin(), values.end(), floats.begin(),
                   [](double value) { return static_cast<float>(value); });
    return floats;
}

}  // namespace

void ReviewPart::add(const sim::Snapshot& moment) {
    if (surfaces_.empty() || surfaces_.back().version != moment.surface_version)
        surfaces_.push_back({moment.surface_version, moment.triangles});
    Picture& picture = pictures_.emplace_back();
    picture.time_s = static_cast<float>(moment.time_s);
    picture.surface = static_cast<uint32_t>(surfaces_.size() - 1);
    picture.x.reserve(moment.x.size());
    for (const auto& x : moment.x) picture.x.push_back(place_of(x));
    picture.damage.reserve(moment.damage.size());
    for (const auto& each : moment.damage)
        picture.damage.push_back({share_of(each[0]), share_of(each[1]), share_of(each[2])});
    const auto add_line = [&](const auto& line, const std::vector<uint8_t>& cut, uint8_t kind) {
        for (size_t i = 0; i < line.size(); ++i) {
            picture.lines.push_back(place_of(line[i]));
            const bool is_cut = i < cut.size() && cut[i] != 0;
            picture.line_flags.push_back(static_cast<uint8_t>(kind | (is_cut ? 1 : 0)));
        }
    };
    add_line(moment.contour, moment.contour_cut, 0);
    add_line(moment.resect_line, moment.resect_cut, kOfMarkedTissue);
    for (int i = 0; i < moment.tool_count; ++i) {
        const sim::ToolSnapshot& tool = moment.tools[as_index(i)];
        const float force = std::hypot(tool.force_n[0], tool.force_n[1], tool.force_n[2]);
        const auto pose = floats_of(tool.pose);
        picture.tools.insert(picture.tools.end(), pose.begin(), pose.end());
        picture.tools.push_back(tool.jaw_rad);
        picture.tools.push_back(force);
        picture.tool_flags.push_back(static_cast<uint8_t>(
            (tool.engaged != 0 ? 1 : 0) | (tool.energised != 0 ? 2 : 0) |
            ((tool.pedals & sim::kPedalCoag) != 0 ? 4 : 0) | (tool.in_contact != 0 ? 8 : 0)));
    }
    if (moment.needle.present == 0) return;
    picture.needle = floats_of(moment.needle.pose);
    for (const auto& x : moment.needle.thread) picture.thread.push_back(place_of(x));
}

/// Vertices that any picture of the part shows, in rising order.
struct ReviewPart::Numbering {
    std::vector<int32_t> body;     ///< Vertex of the body by number.
    std::vector<uint32_t> number;  ///< The other way round.
    std::vector<uint32_t> born;    ///< First picture that has it, by number: cuts make copies.
};

ReviewPart::Numbering ReviewPart::numbering() const {
    Numbering result;
    std::vector<uint8_t> shown(pictures_.back().x.size(), 0);
    for (const Surface& surface : surfaces_)
        for (const sim::SurfaceTriangle& triangle : surface.triangles)
            for (const int32_t v : triangle.vertex) shown[as_index(v)] = 1;
    result.number.resize(shown.size(), 0);
    for (size_t v = 0; v < shown.size(); ++v) {
        if (shown[v] == 0) continue;
        result.number[v] = static_cast<uint32_t>(result.body.size());
        result.body.push_back(static_cast<int32_t>(v));
        uint32_t born = 0;
        while (pictures_[born].x.size() <= v) ++born;
        result.born.push_back(born);
    }
    return result;
}

/// Each surface as what it changes in the one before; the first changes an empty one.
void ReviewPart::put_surfaces(std::string& words, std::string& bytes,
                              const Numbering& numbering) const {
    std::string heads, gaps, tissues;
    Corners corners;
    const std::vector<sim::SurfaceTriangle>* before = nullptr;
    for (const Surface& surface : surfaces_) {
        uint32_t edits = 0;
        size_t next = 0;
        for (size_t i = 0; i < surface.triangles.size(); ++i) {
            const sim::SurfaceTriangle& triangle = surface.triangles[i];
            if (before != nullptr && i < before->size() && same((*before)[i], triangle)) continue;
            ++edits;
            put(gaps, static_cast<uint32_t>(i - next));
            next = i + 1;
            corners.add({numbering.number[as_index(triangle.vertex[0])],
                         numbering.number[as_index(triangle.vertex[1])],
                         numbering.number[as_index(triangle.vertex[2])]});
            tissues.push_back(static_cast<char>(static_cast<uint8_t>(triangle.tissue) |
                                                (triangle.fresh != 0 ? 0x80 : 0)));
        }
        put(heads, static_cast<uint32_t>(surface.triangles.size()));
        put(heads, edits);
        before = &surface.triangles;
    }
    words += heads + gaps;
    bytes += corners.bytes() + tissues;
}

void ReviewPart::put_damage(std::string& bytes, const Numbering& numbering) const {
    for (size_t p = 0; p < pictures_.size(); ++p)
        for (size_t kind = 0; kind < 3; ++kind)
            for (size_t n = 0; n < numbering.body.size(); ++n) {
                const auto v = as_index(numbering.body[n]);
                const auto at = [&](size_t picture) {
                    return pictures_[std::max<size_t>(picture, numbering.born[n])].damage[v][kind];
                };
                const int before = p == 0 ? 0 : at(p - 1);
                bytes.push_back(static_cast<char>(at(p) - before));
            }
}

/// Picture after picture: the first by its differences from place to place, which lie side by side,
/// the others by theirs to the one before. Low bytes of all, then high bytes, nearly all zero.
void ReviewPart::put_places(std::string& bytes, const Numbering& numbering) const {
    const size_t vertices = numbering.body.size(), count = vertices + pictures_.back().lines.size();
    std::vector<uint16_t> steps;
    steps.reserve(3 * count * pictures_.size());
    std::vector<uint16_t> kept(3 * count, 0);
    for (size_t p = 0; p < pictures_.size(); ++p) {
        const auto at = [&](size_t n, size_t axis) {
            if (n >= vertices) return pictures_[p].lines[n - vertices][axis];
            const size_t first = std::max<size_t>(p, numbering.born[n]);
            return pictures_[first].x[as_index(numbering.body[n])][axis];
        };
        for (size_t i = 0; i < 3 * count; ++i) {
            const uint16_t seen = at(i % count, i / count);
            const uint16_t now = p == 0 || moved(seen, kept[i]) ? seen : kept[i];
            const uint16_t before = p > 0 ? kept[i] : i > 0 ? kept[i - 1] : uint16_t{0};
            steps.push_back(zigzag(now, before));
            kept[i] = now;
        }
    }
    bytes += in_planes(steps, 2);
}

bool ReviewPart::has_needle() const {
    const std::array<float, kReviewNeedleFloats> none{};
    return std::any_of(pictures_.begin(), pictures_.end(),
                       [&](const Picture& picture) { return picture.needle != none; });
}

/// As they are: from picture to picture a thread has more points or fewer.
void ReviewPart::put_threads(std::string& bytes) const {
    std::vector<uint16_t> places;
    for (size_t axis = 0; axis < 3; ++axis)
        for (const Picture& picture : pictures_)
            for (const Place& place : picture.thread) places.push_back(place[axis]);
    bytes += in_planes(places, 2);
}

std::string ReviewPart::encoded() const {
    if (pictures_.empty()) return {};
    const Numbering vertices = numbering();
    const Picture& last = pictures_.back();
    const bool needle = has_needle();
    size_t thread_points = 0;
    for (const Picture& picture : pictures_) thread_points += picture.thread.size();
    std::string words, bytes;
    for (const size_t value :
         {size_t{kReviewPartVersion}, pictures_.size(), vertices.body.size(), surfaces_.size(),
          last.lines.size(), last.tool_flags.size(), size_t{needle}, thread_points})
        put(words, static_cast<uint32_t>(value));
    for (const Picture& picture : pictures_) put(words, picture.time_s);
    for (const Picture& picture : pictures_) put(words, picture.surface);
    for (const Picture& picture : pictures_)
        for (const float value : picture.tools) put(words, value);
    if (needle) {
        for (const Picture& picture : pictures_)
            for (const float value : picture.needle) put(words, value);
        for (const Picture& picture : pictures_)
            put(words, static_cast<uint32_t>(picture.thread.size()));
    }
    for (const Picture& picture : pictures_)
        bytes.append(picture.tool_flags.begin(), picture.tool_flags.end());
    put_surfaces(words, bytes, vertices);
    for (const Picture& picture : pictures_)
        bytes.append(picture.line_flags.begin(), picture.line_flags.end());
    put_damage(bytes, vertices);
    put_places(bytes, vertices);
    put_threads(bytes);
    words += bytes;
    // Qt puts the length before the stream, most significant byte first.
    const QByteArray packed = qCompress(reinterpret_cast<const uchar*>(words.data()),
                                        static_cast<qsizetype>(words.size()), kZlibLevel);
    return packed.mid(4).toStdString();
}

}  // namespace placode::reports
