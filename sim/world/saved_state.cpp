// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/world/saved_state.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <type_traits>

#include "sim/solver/topology.h"
#include "sim/world/scene.h"
#include "sim/world/scratch.h"
#include "sim/world/state.h"

namespace placode::sim {
namespace {

constexpr uint64_t kFormat = 0x3230545441545350;  // "PSTATT02", byte order included

template <class T>
inline constexpr bool kIsVector = false;
template <class T, class A>
inline constexpr bool kIsVector<std::vector<T, A>> = true;
template <class T>
inline constexpr bool kIsArray = false;
template <class T, size_t N>
inline constexpr bool kIsArray<std::array<T, N>> = true;

/// FNV-1a over words of eight bytes, four chains side by side: bytewise it would take longer than
/// all the rest.
class WordHash {
 public:
    void bytes(const void* data, size_t size) noexcept {
        const auto* p = static_cast<const unsigned char*>(data);
        while (size >= 32) {
            uint64_t word[4];
            std::memcpy(word, p, 32);
            for (int i = 0; i < 4; ++i) chain_[i] = (chain_[i] ^ word[i]) * kPrime;
            p += 32;
            size -= 32;
        }
        for (; size > 0; --size, ++p) chain_[0] = (chain_[0] ^ *p) * kPrime;
    }
    [[nodiscard]] uint64_t value() const noexcept {
        uint64_t all = 14695981039346656037ULL;
        for (const uint64_t c : chain_) all = (all ^ (c ^ c >> 32)) * kPrime;
        return all;
    }

 private:
    static constexpr uint64_t kPrime = 1099511628211ULL;
    uint64_t chain_[4] = {1, 2, 3, 4};
};

/// Goes down to values that are bytes. `Sink::bytes` gets them, `Sink::size` the sizes of vectors.
template <class Sink>
class Walk {
 public:
    explicit Walk(Sink& sink) : sink_(sink) {}
    template <class... T>
    void state(T&... parts) {
        (one(parts), ...);
    }
    template <class... T>
    void kept(T&... parts) {
        if constexpr (Sink::kKeeps) (one(parts), ...);
    }
    template <class List>
    void state_of(const int32_t& count, List& list) {
        sink_.part(count, list.size());
        if constexpr (kPlainBytes<typename List::value_type>)
            sink_.bytes(list.data(),
                        static_cast<size_t>(count) * sizeof(typename List::value_type));
        else
            for (auto& element : std::span(list).first(static_cast<size_t>(count))) one(element);
    }
    template <class List>
    void kept_of(const int32_t& count, List& list) {
        if constexpr (Sink::kKeeps) state_of(count, list);
    }
    template <class... T>
    void constant(const T&...) const noexcept {}

 private:
    template <class T>
    void one(T& value) {
        using Value = std::remove_const_t<T>;
        if constexpr (std::same_as<Value, TopologyPointer>) {
            if (value) fields(*value, *this);
        } else if constexpr (kPlainBytes<Value>) {
            sink_.bytes(&value, sizeof value);
        } else if constexpr (kIsVector<Value>) {
            sink_.size(value);
            if constexpr (kPlainBytes<typename Value::value_type>)
                sink_.bytes(value.data(), value.size() * sizeof(typename Value::value_type));
            else
                for (auto& element : value) one(element);
        } else if constexpr (kIsArray<Value>) {
            for (auto& element : value) one(element);
        } else {
            fields(value, *this);
        }
    }
    Sink& sink_;
};

struct Hasher {
    static constexpr bool kKeeps = false;
    void bytes(const void* data, size_t size) noexcept { hash.bytes(data, size); }
    template <class V>
    void size(const V& v) noexcept {
        const uint64_t n = v.size();
        hash.bytes(&n, sizeof n);
    }
    void part(int32_t, size_t) noexcept {}
    WordHash hash;
};

struct Counter {
    static constexpr bool kKeeps = true;
    void bytes(const void*, size_t size) noexcept { count += size; }
    template <class V>
    void size(const V&) noexcept {
        count += sizeof(uint64_t);
    }
    void part(int32_t, size_t) noexcept {}
    size_t count = 0;
};

struct Writer {
    static constexpr bool kKeeps = true;
    void bytes(const void* data, size_t size) noexcept {
        if (size > 0) std::memcpy(to, data, size);
        to += size;
    }
    template <class V>
    void size(const V& v) noexcept {
        const uint64_t n = v.size();
        bytes(&n, sizeof n);
    }
    void part(int32_t, size_t) noexcept {}
    uint8_t* to;
};

struct Reader {
    static constexpr bool kKeeps = true;
    void bytes(void* data, size_t size) {
        if (size > in.size()) throw StateError("saved state: it is cut off; save it again");
        if (size > 0) std::memcpy(data, in.data(), size);
        in = in.subspan(size);
    }
    template <class V>
    void size(V& v) {
        uint64_t n = 0;
        bytes(&n, sizeof n);
        // Lists that are refilled have room for what they can hold; all others keep their size.
        if (n > std::max(v.size(), v.capacity())) throw other_scene(n, v.capacity());
        if constexpr (std::is_default_constructible_v<typename V::value_type>)
            v.resize(n);
        else if (n != v.size())
            throw other_scene(n, v.size());
    }
    void part(int32_t count, size_t room) const {
        if (count < 0 || static_cast<size_t>(count) > room)
            throw other_scene(static_cast<size_t>(count), room);
    }
    static StateError other_scene(size_t found, size_t room) {
        return StateError("saved state: a list of " + std::to_string(found) + " entries where " +
                          std::to_string(room) + " have room; it belongs to another scene");
    }
    std::span<const uint8_t> in;
};

struct Head {
    uint64_t format = 0, scene = 0, size = 0, check = 0;
};

/// Sizes of the body, its rest shape and the instruments: not materials, which live tuning changes.
uint64_t scene_mark(const Scene& scene) noexcept {
    WordHash hash;
    const TetMesh& mesh = scene.body.mesh();
    hash.bytes(mesh.rest.data(), mesh.rest.size() * sizeof(Vec3));
    hash.bytes(mesh.tets.data(), mesh.tets.size() * sizeof(mesh.tets[0]));
    const uint64_t counts[] = {scene.tools.size(),
                               static_cast<uint64_t>(scene.body.vertex_capacity()),
                               scene.heat.has_value(), scene.suture.has_value(), sizeof(State)};
    hash.bytes(counts, sizeof counts);
    return hash.value();
}

uint64_t check_of(std::span<const uint8_t> bytes) noexcept {
    WordHash hash;
    hash.bytes(bytes.data(), bytes.size());
    return hash.value();
}

}  // namespace

uint64_t whole_hash(const State& state) noexcept {
    Hasher hasher;
    Walk walk(hasher);
    fields(state, walk);
    return hasher.hash.value();
}

void save_state(const Scene& scene, const State& state, std::vector<uint8_t>& into) {
    Counter counter;
    Walk count(counter);
    fields(state, count);
    into.resize(sizeof(Head) + counter.count);
    Writer writer{into.data() + sizeof(Head)};
    Walk walk(writer);
    fields(state, walk);
    const auto body = std::span(into).subspan(sizeof(Head));
    const Head head{kFormat, scene_mark(scene), body.size(), check_of(body)};
    std::memcpy(into.data(), &head, sizeof head);
}

std::vector<uint8_t> save_state(const Scene& scene, const State& state) {
    std::vector<uint8_t> saved;
    save_state(scene, state, saved);
    return saved;
}

namespace {

Head head_of(std::span<const uint8_t> saved) {
    Head head;
    if (saved.size() < sizeof head) throw StateError("saved state: it is cut off; save it again");
    std::memcpy(&head, saved.data(), sizeof head);
    return head;
}

void read(State& state, std::span<const uint8_t> body) {
    Reader reader{body};
    Walk walk(reader);
    fields(state, walk);
    state.scratch->forget();
    state.event_count = 0;
    state.flags = 0;
}

}  // namespace

void load_state(const Scene& scene, State& state, std::span<const uint8_t> saved) {
    const Head head = head_of(saved);
    const auto body = saved.subspan(sizeof head);
    if (head.format != kFormat)
        throw StateError("saved state: it is of another format; save it with this program");
    if (head.scene != scene_mark(scene))
        throw StateError(
            "saved state: it belongs to another scene; build the scene that it was "
            "saved from");
    if (head.size != body.size() || head.check != check_of(body))
        throw StateError("saved state: it is cut off or damaged; save it again");
    read(state, body);  // sound bytes of this scene and format: it does not fail
}

void load_own_state(State& state, std::span<const uint8_t> saved) {
    const Head head = head_of(saved);
    const auto body = saved.subspan(sizeof head);
    if (head.format != kFormat || head.size != body.size())
        throw StateError("saved state: it is cut off or damaged; save it again");
    read(state, body);
}

}  // namespace placode::sim
