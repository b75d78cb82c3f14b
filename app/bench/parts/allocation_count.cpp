#include "app/bench/parts/allocation_count.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::uint64_t> allocations{0};

#if defined(__clang__)
#define FYD_ASKS_SANITIZER (__has_feature(thread_sanitizer) || __has_feature(address_sanitizer))
#else
#define FYD_ASKS_SANITIZER 0
#endif

#if !FYD_ASKS_SANITIZER
void* allocate(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

void* allocate(std::size_t size, std::align_val_t alignment) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  const auto align = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(align, (size + align - 1) / align * align)) return memory;
  throw std::bad_alloc();
}
#endif

}  // namespace

#if FYD_ASKS_SANITIZER
// clang's sanitizers have the operators themselves, in the program; they tell of each allocation.
extern "C" __attribute__((disable_sanitizer_instrumentation)) void
__sanitizer_malloc_hook(  // NOLINT(bugprone-reserved-identifier)
    const volatile void* /*memory*/, std::size_t /*size*/) {
  allocations.fetch_add(1, std::memory_order_relaxed);
}
#else
void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void* operator new(std::size_t size, std::align_val_t alignment) { return allocate(size, alignment); }
void* operator new[](std::size_t size, std::align_val_t alignment) { return allocate(size, alignment); }
// std::stable_sort's buffer.
void* operator new(std::size_t size, const std::nothrow_t& /*none*/) noexcept {
  try {
    return allocate(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
#endif

namespace fyd::bench {

AllocationCount::AllocationCount() : start_(allocations.load()) {}
std::uint64_t AllocationCount::count() const { return allocations.load() - start_; }

}  // namespace fyd::bench
