// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An interposer: counts what the current thread allocates, by `new` or by the C library, and which
// mutexes it locks. Include it in the one source file of a test that has to show that a path does
// neither. Under a sanitizer, which stands there itself, only `new` is counted.

#include <dlfcn.h>
#include <pthread.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace placode::test {
inline thread_local long allocations = 0;
inline thread_local long locks = 0;
}  // namespace placode::test

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PLACODE_ONLY_NEW_IS_COUNTED

// The compiler sees through the pair below and takes malloc and free for strangers.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"

void* operator new(std::size_t size) {
    ++placode::test::allocations;
    if (void* place = std::malloc(size)) return place;
    throw std::bad_alloc();
}
// std::stable_partition asks so.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++placode::test::allocations;
    return std::malloc(size);
}
void* operator new(std::size_t size, std::align_val_t align) {
    ++placode::test::allocations;
    const auto edge = static_cast<std::size_t>(align);
    if (void* place = std::aligned_alloc(edge, (size + edge - 1) / edge * edge)) return place;
    throw std::bad_alloc();
}
void operator delete(void* place) noexcept { std::free(place); }
void operator delete(void* place, std::size_t) noexcept { std::free(place); }
void operator delete(void* place, const std::nothrow_t&) noexcept { std::free(place); }
void operator delete(void* place, std::align_val_t) noexcept { std::free(place); }
void operator delete(void* place, std::size_t, std::align_val_t) noexcept { std::free(place); }

#else

// glibc's own names of what stands behind malloc; `new` of the C++ library calls malloc.
extern "C" {
void* __libc_malloc(std::size_t size);                      // NOLINT
void* __libc_calloc(std::size_t count, std::size_t size);   // NOLINT
void* __libc_realloc(void* place, std::size_t size);        // NOLINT
void* __libc_memalign(std::size_t edge, std::size_t size);  // NOLINT

void* malloc(std::size_t size) noexcept {
    ++placode::test::allocations;
    return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
    ++placode::test::allocations;
    return __libc_calloc(count, size);
}
void* realloc(void* place, std::size_t size) noexcept {
    ++placode::test::allocations;
    return __libc_realloc(place, size);
}
void* aligned_alloc(std::size_t edge, std::size_t size) noexcept {
    ++placode::test::allocations;
    return __libc_memalign(edge, size);
}

int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
    using Lock = int (*)(pthread_mutex_t*);
    // Constant initialisation: a guarded one would lock in its turn.
    static std::atomic<Lock> found{nullptr};
    Lock next = found.load(std::memory_order_relaxed);
    if (next == nullptr) {
        next = reinterpret_cast<Lock>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
        found.store(next, std::memory_order_relaxed);
    }
    ++placode::test::locks;
    return next(mutex);
}
}

#endif
