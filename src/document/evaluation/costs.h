#pragma once
#include <map>
#include <mutex>
#include <string>

#include "document/document.h"

namespace blossom {

/// How long features took when they were computed last, by which progress is measured. Thread-safe.
class Costs {
 public:
  void took(const Feature&, double milliseconds);
  /// Of one that was never computed, the time of the last one of its type, or that of a typical feature. Above 0.
  [[nodiscard]] double expected(const Feature&) const;

  /// How many times as long as computing it took to show the result, a sequence or a shape.
  void showingTook(const Feature&, bool sequence, double timesAsLong);
  /// Of a type that was never shown, what is usual: the frames of a sequence, each of which is drawn, take most of the time.
  [[nodiscard]] double expectedShowing(const Feature&, bool sequence) const;

 private:
  mutable std::mutex mutex_;
  std::map<FeatureId, double> byFeature_;
  std::map<std::string, double> byType_;
  std::map<std::pair<FeatureId, bool>, double> showingOfFeature_;
  std::map<std::pair<std::string, bool>, double> showingOfType_;
};

/// The share of a whole that is done while its parts are done one by one, each expected to take some time. A part that turns
/// out to be there already is taken out of the whole. Never falls.
class ShareDone {
 public:
  explicit ShareDone(double expected) : left_(expected) {}
  [[nodiscard]] double now() const { return left_ > 0 ? done_ / (done_ + left_) : 1; }
  /// With a part of it being at work.
  [[nodiscard]] double with(double expected) const { return left_ > 0 ? (done_ + expected) / (done_ + left_) : 1; }
  void finish(double expected, bool wasThere) {
    left_ -= expected;
    if (!wasThere) done_ += expected;
  }

 private:
  double done_ = 0, left_;
};

}  // namespace blossom
