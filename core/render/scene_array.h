#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace glide {

/// Items of which the GPU has a copy, and from which one on that copy is out of date. Owned by the
/// thread that draws.
template <class T>
class SceneArray {
 public:
  const std::vector<T>& items() const { return items_; }
  std::size_t size() const { return items_.size(); }

  void append(const T& item) {
    changed_from_ = std::min(changed_from_, items_.size());
    items_.push_back(item);
  }
  /// What begins like the items before counts as unchanged as far as it does.
  void assign(std::vector<T> items) {
    const auto change = std::mismatch(items_.begin(), items_.end(), items.begin(), items.end());
    const auto same = static_cast<std::size_t>(std::distance(items_.begin(), change.first));
    changed_from_ = std::min(changed_from_, same);
    items_ = std::move(items);
  }

  /// Items from here on have changed since markUploaded().
  std::size_t changedFrom() const { return std::min(changed_from_, items_.size()); }
  bool isChanged() const { return changedFrom() < items_.size(); }
  void markUploaded() { changed_from_ = items_.size(); }
  /// The GPU's copy is gone.
  void markLost() { changed_from_ = 0; }

 private:
  std::vector<T> items_;
  std::size_t changed_from_ = 0;
};

}  // namespace glide
