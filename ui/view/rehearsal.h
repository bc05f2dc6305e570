#pragma once

namespace blossom::ui {

class Painter;

/// Draws one of everything, small and unseen, with a fresh painter: so the graphics driver translates its shaders before
/// anybody waits for a picture.
void rehearse(Painter&);

}  // namespace blossom::ui
