#include "ui/view/smoothing.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkTextureObject.h>

#include <QMatrix4x4>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <array>

namespace blossom::ui {

namespace {

// Eight queens on a grid of eighths of a pixel: every row and column has one, so that edges of every slope get eight steps.
constexpr std::array<std::array<int, 2>, Smoothing::frames> places{
    {{0, 0}, {-3, -1}, {1, -3}, {3, 1}, {-1, 3}, {-2, -4}, {2, 2}, {-4, 4}}};

void copy(QOpenGLExtraFunctions& gl, unsigned int from, unsigned int to, int width, int height) {
  gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
  gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
  gl.glDisable(GL_SCISSOR_TEST);
  gl.glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

/// What shines through leaves its opacity in the frame buffer, and a picture taken of the window would be blended by it.
void makeOpaque(QOpenGLExtraFunctions& gl, vtkOpenGLState& state, unsigned int frameBuffer) {
  gl.glBindFramebuffer(GL_FRAMEBUFFER, frameBuffer);
  state.vtkglDisable(GL_SCISSOR_TEST);
  state.vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  state.vtkglClearColor(0, 0, 0, 1);
  state.vtkglClear(GL_COLOR_BUFFER_BIT);
  state.vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace

QPointF Smoothing::offset() const {
  const auto& place = places[static_cast<std::size_t>(taken_ % frames)];
  return QPointF(place[0], place[1]) / frames;
}

void Smoothing::take(vtkGenericOpenGLRenderWindow& window, unsigned int frameBuffer) {
  QOpenGLExtraFunctions& gl = *QOpenGLContext::currentContext()->extraFunctions();
  const int width = window.GetSize()[0], height = window.GetSize()[1];
  vtkOpenGLFramebufferObject& drawn = *window.GetDisplayFramebuffer();
  if (taken_++ == 0) {
    copy(gl, drawn.GetFBOIndex(), frameBuffer, width, height);
    return makeOpaque(gl, *window.GetState(), frameBuffer);
  }
  // The mean grows with the weight of one more frame. VTK keeps a copy of OpenGL's state, so it is changed through VTK.
  window.GetShaderCache()->ReleaseCurrentShader();
  vtkOpenGLState& state = *window.GetState();
  gl.glBindFramebuffer(GL_FRAMEBUFFER, frameBuffer);
  state.vtkglViewport(0, 0, width, height);
  state.vtkglDisable(GL_SCISSOR_TEST);
  state.vtkglDisable(GL_DEPTH_TEST);
  state.vtkglDisable(GL_CULL_FACE);
  state.vtkglEnable(GL_BLEND);
  state.vtkglBlendFuncSeparate(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA, GL_CONSTANT_ALPHA,
                               GL_ONE_MINUS_CONSTANT_ALPHA);
  gl.glBlendColor(0, 0, 0, 1.0F / static_cast<float>(taken_));
  if (!blitter_.isCreated()) blitter_.create();
  state.vtkglActiveTexture(GL_TEXTURE0);
  blitter_.bind();
  blitter_.blit(drawn.GetColorAttachmentAsTextureObject(0)->GetHandle(), QMatrix4x4(),
                QOpenGLTextureBlitter::OriginBottomLeft);
  blitter_.release();
  state.vtkglEnable(GL_DEPTH_TEST);
  makeOpaque(gl, state, frameBuffer);
}

void Smoothing::release() {
  if (blitter_.isCreated()) blitter_.destroy();
  restart();
}

}  // namespace blossom::ui
