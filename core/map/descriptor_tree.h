#pragma once

#include "feature/feature_set.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace glide {

/// Binary search tree over descriptors, each with the number of its owner. An inner node tests one
/// bit, the one that halves best what lies below it; descriptors lie in leaves of bounded size
/// (Schlegel and Grisetti, "HBST", RA-L 2018; docs/algorithms/place-recognition.md). Its shape
/// depends on the order of the calls and on nothing else.
class DescriptorTree {
 public:
  using Owner = std::uint32_t;

  DescriptorTree();
  ~DescriptorTree();
  DescriptorTree(DescriptorTree&&) noexcept;
  DescriptorTree& operator=(DescriptorTree&&) noexcept;

  void insert(const Descriptor& descriptor, Owner owner);

  /// Takes out all descriptors of an owner, joins leaves that became small and frees their memory.
  /// Linear in the number of descriptors.
  void remove(Owner owner);

  /// Appends to `owners` those of the descriptors within `max_distance` bits of `descriptor` that
  /// lie in its leaf and in the nearest leaves beyond the last tests: most of them, not all. An
  /// owner may come repeatedly.
  void search(const Descriptor& descriptor, int max_distance, std::vector<Owner>* owners) const;

  struct Shape {
    std::size_t descriptors = 0, leaves = 0;
    std::size_t largest_leaf = 0;  ///< descriptors
    std::size_t depth = 0;         ///< tests on the longest path
    std::size_t bytes = 0;         ///< memory held
  };
  Shape shape() const;

 private:
  struct Node;
  std::unique_ptr<Node> root_;
};

}  // namespace glide
