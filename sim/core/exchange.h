// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The only two ways data crosses a thread border: the latest value, or a ring with one writer and
// one reader. Neither locks, allocates (after construction) or waits.

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace placode::sim {

/// Triple buffer: the writer always has a free slot, the reader always gets the newest complete
/// value. One writer thread, one reader thread. T is copied or filled in place.
template <class T>
class Latest {
 public:
    Latest() = default;
    explicit Latest(const T& initial) { slots_.fill(initial); }

    /// Writer: slot to fill; keeps what was written two publications ago (capacity is reused).
    [[nodiscard]] T& back() noexcept { return slots_[write_]; }
    /// Writer: makes `back()` the newest value.
    void publish() noexcept {
        write_ =
            middle_.exchange(static_cast<uint8_t>(write_ | kFresh), std::memory_order_acq_rel) &
            kIndex;
    }
    void publish(const T& value) noexcept(noexcept(slots_[0] = value)) {
        back() = value;
        publish();
    }
    /// Reader: takes over the newest value; true when it changed since the last call.
    bool refresh() noexcept {
        if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
        read_ = middle_.exchange(read_, std::memory_order_acq_rel) & kIndex;
        return true;
    }
    /// Reader: the value taken over last.
    [[nodiscard]] const T& front() const noexcept { return slots_[read_]; }

 private:
    static constexpr uint8_t kIndex = 3, kFresh = 4;
    std::array<T, 3> slots_{};
    uint8_t write_ = 0;  // writer thread
    alignas(64) std::atomic<uint8_t> middle_{1};
    alignas(64) uint8_t read_ = 2;  // reader thread
};

/// Bounded ring, one writer and one reader. `push` returns false when full; nothing is overwritten.
template <class T>
class Ring {
 public:
    /// Capacity is rounded up to a power of two.
    explicit Ring(size_t capacity) {
        size_t n = 2;
        while (n < capacity) n *= 2;
        slots_.resize(n);
    }
    [[nodiscard]] bool push(const T& value) noexcept {
        const size_t head = head_.load(std::memory_order_relaxed);
        if (head - tail_.load(std::memory_order_acquire) == slots_.size()) return false;
        slots_[head & (slots_.size() - 1)] = value;
        head_.store(head + 1, std::memory_order_release);
        return true;
    }
    [[nodiscard]] bool pop(T& value) noexcept {
        const size_t tail = tail_.load(std::memory_order_relaxed);
        if (tail == head_.load(std::memory_order_acquire)) return false;
        value = slots_[tail & (slots_.size() - 1)];
        tail_.store(tail + 1, std::memory_order_release);
        return true;
    }
    [[nodiscard]] size_t size() const noexcept {
        return head_.load(std::memory_order_acquire) - tail_.load(std::memory_order_acquire);
    }

 private:
    std::vector<T> slots_;
    alignas(64) std::atomic<size_t> head_{0};
    alignas(64) std::atomic<size_t> tail_{0};
};

}  // namespace placode::sim
