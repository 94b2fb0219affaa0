#include "map/descriptor_tree.h"

#include "feature/descriptor.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace glide {
namespace {

constexpr std::size_t kBits = 256;

// Leaves of 64, and 5 searched for each feature: docs/decisions/0003-place-index.md.
constexpr std::size_t kMaxLeaf = 64;
constexpr std::size_t kLeavesBeyond = 4;

// A test that leaves fewer than this share on one side only makes paths longer.
constexpr double kMinShare = 0.05;

// Small siblings become one leaf again well below the size at which it would split.
constexpr std::size_t kJoinedLeaf = kMaxLeaf / 2;

bool bitOf(const Descriptor& descriptor, std::size_t bit) {
  return (descriptor[bit / 64] >> (bit % 64) & 1U) != 0;
}

/// 0, 1, 2, ...: descriptorDistances() takes indices.
constexpr std::array<int, kMaxLeaf> countUp() {
  std::array<int, kMaxLeaf> indices{};
  for (std::size_t i = 0; i < kMaxLeaf; ++i) indices[i] = static_cast<int>(i);
  return indices;
}

/// The bit that divides the descriptors best, and how many are on its smaller side.
struct Test {
  std::size_t bit = 0;
  std::size_t smaller_side = 0;
};

Test bestTest(std::span<const Descriptor> descriptors) {
  std::array<std::size_t, kBits> ones{};
  for (const Descriptor& descriptor : descriptors) {
    for (std::size_t bit = 0; bit < kBits; ++bit) ones[bit] += bitOf(descriptor, bit) ? 1U : 0U;
  }
  Test best;
  for (std::size_t bit = 0; bit < kBits; ++bit) {
    const std::size_t smaller = std::min(ones[bit], descriptors.size() - ones[bit]);
    if (smaller > best.smaller_side) best = {bit, smaller};
  }
  return best;
}

}  // namespace

/// An inner node has two children and no descriptors; a leaf has no children.
struct DescriptorTree::Node {
  std::size_t bit = 0;
  std::array<std::unique_ptr<Node>, 2> child;  // bit is 0, bit is 1
  std::vector<Descriptor> descriptors;
  std::vector<Owner> owners;  // of the descriptors
  std::size_t limit = kMaxLeaf;

  bool isLeaf() const { return child[0] == nullptr; }
  const std::unique_ptr<Node>& side(const Descriptor& descriptor) const {
    return child[bitOf(descriptor, bit) ? 1 : 0];
  }
  const std::unique_ptr<Node>& otherSide(const Descriptor& descriptor) const {
    return child[bitOf(descriptor, bit) ? 0 : 1];
  }

  void add(const Descriptor& descriptor, Owner owner) {
    descriptors.push_back(descriptor);
    owners.push_back(owner);
  }

  void split();
  void erase(Owner owner);
  void joinChildren();
  void search(const Descriptor& descriptor, int max_distance, std::vector<Owner>* found) const;
  void measure(std::size_t depth, Shape* shape) const;
};

void DescriptorTree::Node::split() {
  const Test test = bestTest(descriptors);
  if (static_cast<double>(test.smaller_side) <
      kMinShare * static_cast<double>(descriptors.size())) {
    limit *= 2;  // (nearly) equal descriptors: try again when there are more
    return;
  }
  bit = test.bit;
  child = {std::make_unique<Node>(), std::make_unique<Node>()};
  for (std::size_t i = 0; i < descriptors.size(); ++i)
    side(descriptors[i])->add(descriptors[i], owners[i]);
  descriptors = std::vector<Descriptor>();  // frees the memory, which = {} would not
  owners = std::vector<Owner>();
}

void DescriptorTree::Node::erase(Owner owner) {
  if (!isLeaf()) {
    for (const std::unique_ptr<Node>& c : child) c->erase(owner);
    joinChildren();
    return;
  }
  if (std::find(owners.begin(), owners.end(), owner) == owners.end()) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < owners.size(); ++i) {
    if (owners[i] == owner) continue;
    descriptors[kept] = descriptors[i];
    owners[kept++] = owners[i];
  }
  descriptors.resize(kept);
  owners.resize(kept);
  descriptors.shrink_to_fit();
  owners.shrink_to_fit();
}

void DescriptorTree::Node::joinChildren() {
  if (!child[0]->isLeaf() || !child[1]->isLeaf()) return;
  if (child[0]->owners.size() + child[1]->owners.size() > kJoinedLeaf) return;
  for (std::unique_ptr<Node>& c : child) {
    for (std::size_t i = 0; i < c->owners.size(); ++i) add(c->descriptors[i], c->owners[i]);
    c.reset();
  }
  limit = kMaxLeaf;
}

void DescriptorTree::Node::search(const Descriptor& descriptor,
                                  int max_distance,
                                  std::vector<Owner>* found) const {
  static constexpr std::array<int, kMaxLeaf> kIndices = countUp();
  std::array<int, kMaxLeaf> distances{};
  for (std::size_t begin = 0; begin < owners.size(); begin += kMaxLeaf) {
    const std::size_t count = std::min(kMaxLeaf, owners.size() - begin);
    descriptorDistances(descriptor,
                        std::span(descriptors).subspan(begin, count),
                        std::span(kIndices).first(count),
                        std::span(distances).first(count));
    for (std::size_t i = 0; i < count; ++i) {
      if (distances[i] <= max_distance) found->push_back(owners[begin + i]);
    }
  }
}

void DescriptorTree::Node::measure(std::size_t depth, Shape* shape) const {
  shape->bytes += sizeof(Node) + descriptors.capacity() * sizeof(Descriptor) +
                  owners.capacity() * sizeof(Owner);
  shape->depth = std::max(shape->depth, depth);
  if (!isLeaf()) {
    for (const std::unique_ptr<Node>& c : child) c->measure(depth + 1, shape);
    return;
  }
  ++shape->leaves;
  shape->descriptors += owners.size();
  shape->largest_leaf = std::max(shape->largest_leaf, owners.size());
}

DescriptorTree::DescriptorTree() : root_(std::make_unique<Node>()) {}
DescriptorTree::~DescriptorTree() = default;
DescriptorTree::DescriptorTree(DescriptorTree&&) noexcept = default;
DescriptorTree& DescriptorTree::operator=(DescriptorTree&&) noexcept = default;

void DescriptorTree::insert(const Descriptor& descriptor, Owner owner) {
  Node* leaf = root_.get();
  while (!leaf->isLeaf()) leaf = leaf->side(descriptor).get();
  leaf->add(descriptor, owner);
  if (leaf->owners.size() > leaf->limit) leaf->split();
}

void DescriptorTree::remove(Owner owner) { root_->erase(owner); }

void DescriptorTree::search(const Descriptor& descriptor,
                            int max_distance,
                            std::vector<Owner>* owners) const {
  // The nearer the test is to the leaf, the fewer descriptors are beyond it and the more alike they
  // are. A path tests a bit once at most.
  std::array<const Node*, kBits> beyond{};
  std::size_t tests = 0;
  const Node* leaf = root_.get();
  for (; !leaf->isLeaf(); leaf = leaf->side(descriptor).get())
    beyond[tests++] = leaf->otherSide(descriptor).get();
  leaf->search(descriptor, max_distance, owners);
  for (std::size_t i = 0; i < std::min(tests, kLeavesBeyond); ++i) {
    const Node* other = beyond[tests - 1 - i];
    while (!other->isLeaf()) other = other->side(descriptor).get();
    other->search(descriptor, max_distance, owners);
  }
}

DescriptorTree::Shape DescriptorTree::shape() const {
  Shape shape;
  root_->measure(0, &shape);
  return shape;
}

}  // namespace glide
