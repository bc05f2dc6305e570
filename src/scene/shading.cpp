#include "scene/shading.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkLookupTable.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <string>

#include "scene/surface_study.h"

namespace blossom {

namespace {

// Directions and colours (times intensity) as in setUpRenderer. Specular power 32 by squaring.
const char* const lights = R"(
  vec3 blossomNormal = normalVCVSOutput;
  vec3 blossomBack = reflect(normalize(vertexVC.xyz), blossomNormal);
  const vec3 blossomKey = vec3(-0.428353, 0.471188, 0.771035), blossomHead = vec3(0.098387, -0.147580, 0.984145),
             blossomFill = vec3(0.870063, 0.096674, 0.483368), blossomRim = vec3(0.314970, 0.494953, -0.809924);
  vec4 blossomLit = max(vec4(0.0), vec4(dot(blossomNormal, blossomKey), dot(blossomNormal, blossomHead),
                                        dot(blossomNormal, blossomFill), dot(blossomNormal, blossomRim)));
  vec4 blossomShine = max(vec4(0.0), vec4(dot(blossomBack, blossomKey), dot(blossomBack, blossomHead),
                                          dot(blossomBack, blossomFill), dot(blossomBack, blossomRim)));
  blossomShine *= blossomShine; blossomShine *= blossomShine; blossomShine *= blossomShine;
  blossomShine *= blossomShine; blossomShine *= blossomShine;
  const mat4x3 blossomLights = mat4x3(0.72, 0.702, 0.6768, 0.36, 0.3564, 0.3528, 0.252, 0.266, 0.28, 0.276, 0.288, 0.30);
  fragOutput0 = vec4(ambientColor + diffuseColor * (blossomLights * blossomLit) +
                     specularColor * (blossomLights * blossomShine), opacity);
)";

// Striped surroundings, far away, in a mirror: stripes are where the direction that the sight line is thrown back to has a
// certain height. It is smooth everywhere, so a stripe breaks only where the normal jumps and bends only where its change
// does. Edges are as wide as a pixel; where stripes are finer than pixels they fade to grey.
const char* const zebraStripes = R"(
  vec3 zebraBack = reflect(normalize(vertexVC.xyz), normalVCVSOutput);
  float zebraAt = dot(zebraBack, zebraAcross);
  float zebraPixel = max(fwidth(zebraAt), 1.0e-6);
  float zebraLight = clamp((0.25 - abs(fract(zebraAt) - 0.5)) / zebraPixel + 0.5, 0.0, 1.0);
  zebraLight = mix(zebraLight, 0.5, smoothstep(0.35, 0.7, zebraPixel));
  fragOutput0 = vec4(mix(vec3(0.04), mix(vec3(0.97), diffuseColor, 0.25), zebraLight), opacity);
)";

// No light falls on a section: its colour is the same from all sides.
const char* const hatching = R"(
  float hatchAt = dot(hatchAcross.xyz, vertexVC.xyz) + hatchAcross.w;
  float hatchWidth = fwidth(hatchAt) * 0.6;
  float hatchNear = abs(fract(hatchAt) - 0.5);
  fragOutput0 = vec4(mix(hatchFill, hatchLines, 1.0 - smoothstep(hatchWidth, 2.0 * hatchWidth, hatchNear)), opacity);
)";

Vec3 turnedToEye(const vtkMatrix4x4& view, const Vec3& d) {
  Vec3 result;
  for (int i = 0; i < 3; ++i)
    result[i] = view.GetElement(i, 0) * d.x() + view.GetElement(i, 1) * d.y() + view.GetElement(i, 2) * d.z();
  return result;
}

void setUniform(vtkUniforms& uniforms, const char* name, const Vec3& v, double w) {
  const std::array<float, 4> values{static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()),
                                    static_cast<float>(w)};
  uniforms.SetUniform4f(name, values.data());
}

void setUniform(vtkUniforms& uniforms, const char* name, const Vec3& v) {
  const std::array<float, 3> values{static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
  uniforms.SetUniform3f(name, values.data());
}

/// In the plane of the picture, across the stripes; its length makes one stripe of each 1.
Vec3 acrossStripes(const ZebraLook& look) {
  const double angle = look.angle * M_PI / 180;
  return Vec3(-std::sin(angle), std::cos(angle), 0) * (look.stripes / 2.0);
}

bool hasCurvature(vtkMapper& mapper, SurfaceDisplay display) {
  vtkDataSet* const data = mapper.GetInputAsDataSet();
  return data && data->GetPointData()->HasArray(curvatureArray(display));
}

/// The values are interpolated, not the colours: bands have the form of the curvature within a triangle too.
void colorByCurvature(vtkMapper& mapper, const FaceShading& shading) {
  mapper.SetScalarModeToUsePointFieldData();
  mapper.SelectColorArray(curvatureArray(shading.display));
  mapper.SetColorModeToMapScalars();
  mapper.SetLookupTable(shading.colors);
  mapper.SetUseLookupTableScalarRange(true);
  mapper.SetInterpolateScalarsBeforeMapping(true);
  mapper.SetScalarVisibility(true);
}

void setUniform(vtkUniforms& uniforms, const char* name, const Color& color) {
  const std::array<float, 3> values{static_cast<float>(color.red), static_cast<float>(color.green),
                                    static_cast<float>(color.blue)};
  uniforms.SetUniform3f(name, values.data());
}

}  // namespace

void useOwnColors(vtkMapper& mapper) {
  const vtkDataSet* const data = mapper.GetInputAsDataSet();
  mapper.SetScalarModeToUseCellData();
  mapper.SetInterpolateScalarsBeforeMapping(false);
  mapper.SetScalarVisibility(data && const_cast<vtkDataSet*>(data)->GetCellData()->GetScalars() != nullptr);
}

vtkSmartPointer<vtkLookupTable> curvatureColors(SurfaceDisplay display, const CurvatureRange& range) {
  constexpr int entries = 256;
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(entries);
  for (int i = 0; i < entries; ++i) {
    const Color color = curvatureColor(display, i / (entries - 1.0));
    table->SetTableValue(i, color.red, color.green, color.blue);
  }
  table->SetTableRange(range.low, range.high);
  return table;
}

void shadeFaces(vtkActor& actor, const FaceShading& shading) {
  vtkShaderProperty& shader = *actor.GetShaderProperty();
  const bool striped = shading.display == SurfaceDisplay::Zebra;
  shader.ClearAllFragmentShaderReplacements();
  shader.AddFragmentShaderReplacement("//VTK::Light::Impl", true, striped ? zebraStripes : lights, false);
  shader.GetFragmentCustomUniforms()->RemoveAllUniforms();
  if (striped) setUniform(*shader.GetFragmentCustomUniforms(), "zebraAcross", acrossStripes(shading.zebra));
  if (showsCurvature(shading.display) && shading.colors && hasCurvature(*actor.GetMapper(), shading.display))
    colorByCurvature(*actor.GetMapper(), shading);
  else
    useOwnColors(*actor.GetMapper());
}

void shadeSection(vtkActor& actor) {
  actor.GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true, hatching, false);
}

void placeHatching(vtkActor& actor, const CutPlane& cut, const HatchLook& look, vtkCamera& camera) {
  vtkUniforms& uniforms = *actor.GetShaderProperty()->GetFragmentCustomUniforms();
  Vec3 eye;
  camera.GetPosition(eye.data());
  const Vec3 x = cut.axis(), y = cut.normal.cross(x);
  const Vec3 across = (std::sin(look.angle) * x - std::cos(look.angle) * y) / look.spacing;
  setUniform(uniforms, "hatchAcross", turnedToEye(*camera.GetModelViewTransformMatrix(), across), across.dot(eye));
  setUniform(uniforms, "hatchFill", look.fill);
  setUniform(uniforms, "hatchLines", look.lines);
}

}  // namespace blossom
