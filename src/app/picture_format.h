#pragma once
#include "exchange/format/format.h"
#include "scene/scene.h"

namespace blossom {

/// PNG as a format that can be written.
Format pngFormat();
/// Films of sequences as a format that can be written.
Format ogvFormat();

/// Options from the values of that format's write options; what is absent is at its default. @throws Error InvalidParameter.
PictureOptions readPictureOptions(const Value& values);

}  // namespace blossom
