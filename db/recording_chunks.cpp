// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording_chunks.h"

#include <bit>
#include <cstring>

#include "db/store_error.h"

namespace placode::db {
namespace {

static_assert(std::endian::native == std::endian::little, "chunks are little-endian");
// A new field in one of these needs a line below and a higher sim::kRecordingFormat.
static_assert(sizeof(sim::ToolInput) == 40 - 4 && sizeof(sim::Input) == 160);
static_assert(sizeof(sim::ToolSample) == 56 && sizeof(sim::Sample) == 256);
static_assert(sizeof(sim::Event) == 48);

// Format 1 had three tools. The fourth stands behind all older fields, so that the columns of an
// old file are simply fewer.
constexpr size_t kToolsOfFormat1 = 3;
static_assert(sim::kMaxTools == kToolsOfFormat1 + 1);
constexpr size_t kInputOfFormat1 = 16 + 3 * 36, kSampleOfFormat1 = 193;

template <class T, class Visit>
void fields_of_tool_input(T& tool, Visit&& visit) {
    visit(tool.position_m);
    visit(tool.orientation);
    visit(tool.jaw_rad);
    visit(tool.pedals);
    visit(tool.engaged);
    visit(tool.reserved);
}

template <class T, class Visit>
void fields_of_tool_sample(T& tool, Visit&& visit) {
    visit(tool.tip_m);
    visit(tool.orientation);
    visit(tool.force_n);
    visit(tool.jaw_rad);
    visit(tool.tip_gap_m);
    visit(tool.power_w);
    visit(tool.pedals);
    visit(tool.in_contact);
    visit(tool.in_view);
    visit(tool.touched);
}

template <class T, class Visit>
void fields(T& record, Visit&& visit, const sim::Input*) {
    visit(record.frame);
    visit(record.substeps);
    visit(record.tool_count);
    for (size_t i = 0; i < kToolsOfFormat1; ++i) fields_of_tool_input(record.tools[i], visit);
    fields_of_tool_input(record.tools[kToolsOfFormat1], visit);  // since format 2
}

template <class T, class Visit>
void fields(T& record, Visit&& visit, const sim::Sample*) {
    visit(record.time_s);
    for (size_t i = 0; i < kToolsOfFormat1; ++i) fields_of_tool_sample(record.tools[i], visit);
    visit(record.placode_peak_c);
    visit(record.placode_peak_cem43_min);
    visit(record.placode_burned_m3);
    visit(record.cut_fraction);
    visit(record.phase);
    visit(record.step_flags);
    fields_of_tool_sample(record.tools[kToolsOfFormat1], visit);  // since format 2
}

template <class T, class Visit>
void fields(T& record, Visit&& visit, const sim::Event*) {
    visit(record.time_s);
    visit(record.kind);
    visit(record.tool);
    visit(record.tissue);
    visit(record.value);
    visit(record.value2);
    visit(record.rest_position_m);
    visit(record.element);
    visit(record.hash);
}

template <class Record>
size_t size_of() {
    size_t size = 0;
    const Record record{};
    fields(
        record, [&size](const auto& field) { size += sizeof(field); },
        static_cast<const Record*>(nullptr));
    return size;
}

template <class Record>
Bytes encode(std::span<const Record> records) {
    const size_t stride = size_of<Record>();
    const size_t count = records.size();
    Bytes before(stride), now(stride), columns(stride * count);
    for (size_t i = 0; i < count; ++i) {
        std::byte* to = now.data();
        fields(
            records[i],
            [&to](const auto& field) {
                std::memcpy(to, &field, sizeof(field));
                to += sizeof(field);
            },
            static_cast<const Record*>(nullptr));
        for (size_t b = 0; b < stride; ++b) columns[b * count + i] = now[b] ^ before[b];
        std::swap(before, now);
    }
    return compress(columns);
}

[[noreturn]] void damaged(const std::string& problem) {
    throw StoreError(StoreError::Kind::kDamaged, "decode: " + problem);
}

// A number from outside must not become an index or an enum that nobody handles.
void check(const sim::Input& input) {
    if (input.tool_count < 0 || input.tool_count > sim::kMaxTools) damaged("a tool count is wrong");
}
void check(const sim::Sample& sample) {
    for (const auto& tool : sample.tools)
        if (static_cast<int>(tool.touched) >= sim::kTissueCount) damaged("a tissue is unknown");
    if (sample.phase > sim::Phase::kCheck) damaged("a phase is unknown");
}
void check(const sim::Event& event) {
    if (static_cast<int>(event.tissue) >= sim::kTissueCount) damaged("a tissue is unknown");
    if (event.tool < -1 || event.tool >= sim::kMaxTools) damaged("a tool is unknown");
}

/// Bytes of a record in format 1; where nothing has changed, as now.
size_t old_size(const sim::Input&) { return kInputOfFormat1; }
size_t old_size(const sim::Sample&) { return kSampleOfFormat1; }
size_t old_size(const sim::Event&) { return size_of<sim::Event>(); }

template <class Record>
void decode(std::span<const std::byte> packed, size_t count, std::vector<Record>& out) {
    const size_t stride =
        stated_size(packed) == old_size(Record{}) * count ? old_size(Record{}) : size_of<Record>();
    if (count > kMostChunkBytes / stride) damaged("the chunk says that it is larger than 64 MiB");
    const Bytes columns = decompress(packed, stride * count);
    Bytes record(size_of<Record>());
    // Nothing is reserved: room for one chunk more at a time would copy all before it with each.
    for (size_t i = 0; i < count; ++i) {
        for (size_t b = 0; b < stride; ++b) record[b] ^= columns[b * count + i];
        Record& target = out.emplace_back();
        const std::byte* from = record.data();
        fields(
            target,
            [&from](auto& field) {
                std::memcpy(&field, from, sizeof(field));
                from += sizeof(field);
            },
            static_cast<const Record*>(nullptr));
        check(target);
    }
}

}  // namespace

Bytes encode_chunk(std::span<const sim::Input> records) { return encode(records); }
Bytes encode_chunk(std::span<const sim::Sample> records) { return encode(records); }
Bytes encode_chunk(std::span<const sim::Event> records) { return encode(records); }

void decode_chunk(std::span<const std::byte> packed, size_t count, std::vector<sim::Input>& out) {
    decode(packed, count, out);
}
void decode_chunk(std::span<const std::byte> packed, size_t count, std::vector<sim::Sample>& out) {
    decode(packed, count, out);
}
void decode_chunk(std::span<const std::byte> packed, size_t count, std::vector<sim::Event>& out) {
    decode(packed, count, out);
}

}  // namespace placode::db
