/// Counts what a piece of code asks of the heap, whichever library asks: C and C++, Eigen and ODE
/// alike.
#pragma once

namespace quad_support::testing {

/// While one lives, every malloc, calloc, realloc, memalign, posix_memalign and aligned_alloc of
/// the process is counted; operator new ends in them. The test program defines these functions
/// itself (allocation_counter.cpp), ahead of glibc's.
class AllocationCounter {
 public:
  AllocationCounter();
  ~AllocationCounter();
  AllocationCounter(const AllocationCounter&) = delete;
  AllocationCounter& operator=(const AllocationCounter&) = delete;
  long count() const;  ///< since construction

  /// False under a sanitizer, which has the heap to itself.
  static bool available();
};

}  // namespace quad_support::testing
