#pragma once
#include <cstddef>
#include <vector>

#include "core/ease.h"
#include "parameter/parameter.h"

/// Keys of a timeline: frames of a sequence at which its t is given. Between two keys t goes from one to the other, before
/// the first and after the last it stays.
namespace blossom {

struct FrameKey {
  int frame = 1;  ///< counted from 1; may lie after the last frame
  double t = 0;
  Ease ease = Ease::Linear;  ///< how it goes on to the next key
  bool hold = false;         ///< it does not: t stays until the next key
  friend bool operator==(const FrameKey&, const FrameKey&) = default;
};

/// A list of records of frame, t and ease.
ParameterSpec frameKeys();
/// Whether a parameter is such a list.
bool isFrameKeys(const ParameterSpec&);

/// Canonical keys in the order of their frames, whatever the order in the list.
/// @throws Error InvalidParameter for two keys at one frame.
std::vector<FrameKey> frameKeysOf(const Value& keys);

/// t at a place of the timeline, 0 at the first of `frames` frames and 1 at the last; that place itself without keys.
double keyedTime(const std::vector<FrameKey>& sorted, double place, int frames);

/// Canonical keys with one more at a frame, where t is what it was. Without keys the first and the last frame get one, too,
/// so that the sequence stays what it is.
Value withKeyAt(const Value& keys, int frame, int frames);
/// With one key, by its place in the list, at another frame: as near to that as keys before and after it allow.
Value withKeyMoved(const Value& keys, std::size_t key, int frame, int frames);

}  // namespace blossom
