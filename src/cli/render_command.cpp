#include <fmt/format.h>

#include <ostream>

#include "app/picture_format.h"
#include "cli/command_line.h"
#include "cli/input.h"
#include "cli/output.h"
#include "cli/progress_display.h"
#include "cli/report.h"
#include "document/edits.h"
#include "document/shown.h"
#include "exchange/format/frames.h"
#include "scene/sequence_pictures.h"

namespace blossom {
namespace {

/// A picture of files, drawn without a display. Its flags are the write options of the PNG format.
class RenderCommand {
 public:
  RenderCommand(CommandLine& line, Invocation& invocation)
      : invocation_(invocation),
        app_(line.add("render", "Draw files into a PNG picture; needs no display.", invocation, [this] { return run(); })) {
    app_.add_option("FILE", files_, "Files to draw together (or model.blossom#feature).")->type_name("..")->expected(0, -1);
    app_.add_option("-o,--output", output_, "The picture.")->type_name("FILE.png");
    app_.add_flag("--light", light_, "The same as --theme light.");
    CommandLine::addDocumentFlags(app_, invocation_);
    options_ =
        std::make_unique<ParameterFlags>(line, app_, invocation.app.formats->find("png")->writeOptions, "", "Picture");
    setExamples(app_,
                {"blossom render part.step -o part.png", "blossom render propeller.json -o p.png --size 1920x1080 --light",
                 "blossom render propeller.json -o stripes.png --display zebra"});
  }

 private:
  /// What the window would show of the file: the shown features of its document, or the last one if all are hidden.
  void addShapes(const std::string& text, const Progress& progress, std::vector<Shape>& shapes) {
    const std::filesystem::path file = fileOfInput(text);
    if (file.string() != text) {
      Document document;
      const FeatureId id = addInput(invocation_, document, text, warnings_);
      shapes.push_back(evaluateFor(invocation_.app, document, id, progress)->evaluated.shape);
      return;
    }
    const OpenedDocument opened = openInput(invocation_, file);
    warnings_.insert(warnings_.end(), opened.warnings.begin(), opened.warnings.end());
    const FeatureId last = lastFeature(opened.document).id;
    Results results;
    const auto result = evaluateFor(invocation_.app, opened.document, last, progress, &results);
    const auto shapeOf = [&](const FeatureId& id) -> const Shape* {
      const auto found = results.find(id);
      return found == results.end() ? nullptr : &found->second->evaluated.shape;
    };
    const std::vector<FeatureId> shown = shownFeatures(opened.document, *invocation_.app.registry, shapeOf);
    for (const FeatureId& id : shown) shapes.push_back(*shapeOf(id));
    if (shown.empty()) shapes.push_back(result->evaluated.shape);
  }

  int run() {
    if (files_.empty())
      throw UsageError("render needs a file to draw.", "\"blossom render part.step -o part.png\" draws a part.");
    if (output_.empty()) throw UsageError("render needs a picture to write.", "Add -o and a name that ends in .png.");
    Value values = options_->values();
    const int cells = sheetCells(values);
    if (light_) values["theme"] = "light";
    PictureOptions options;
    try {
      options = readPictureOptions(values);
    } catch (const Error& error) {
      throw UsageError(error.message(), error.hint(), error.code());
    }
    std::vector<std::filesystem::path> inputs;
    for (const std::string& file : files_) inputs.push_back(fileOfInput(file));
    const auto planned = plannedOutputs(*invocation_.app.formats, {output_}, inputs, nullptr);
    if (!planned[0].format || planned[0].format->id != "png")
      throw Error(ErrorCode::FormatUnknown, fmt::format("The picture {} is no PNG file.", output_),
                  "Give it a name that ends in .png.");

    ProgressDisplay display(invocation_);
    const Progress progress = display.progress();
    std::vector<Shape> shapes;
    for (const std::string& file : files_) addShapes(file, progress.part(0, 0.5), shapes);
    const Stopwatch drawing;
    std::optional<CurvatureRange> colors;
    if (cells > 0)
      renderContactSheet(onlySequence(shapes), output_, options, cells, progress.part(0.5, 1));
    else
      colors = renderPicture(shapes, output_, options, progress.part(0.5, 1));
    report(planned, options, colors, drawing.elapsedMs());
    return 0;
  }

  static const Sequence& onlySequence(const std::vector<Shape>& shapes) {
    const auto* sequence = shapes.size() == 1 ? shapes.front().get<Sequence>() : nullptr;
    if (sequence) return *sequence;
    throw Error(ErrorCode::InvalidInput, "A contact sheet shows the frames of one sequence.",
                "Name the feature that has frames, such as model.blossom#morph, or leave --sheet out.");
  }

  void report(const std::vector<Output>& planned, const PictureOptions& options, const std::optional<CurvatureRange>& colors,
              double drawMs) const {
    Value result{{"kind", "picture"}, {"width", options.width}, {"height", options.height}};
    if (colors) {  // the ends of the scale, in 1/mm or 1/mm^2
      result["curvature_low"] = colors->low;
      result["curvature_high"] = colors->high;
    }
    Value stats{{"render_ms", drawMs}, {"total_ms", invocation_.elapsedMs()}};
    std::ostream& out = invocation_.terminal.out;
    if (invocation_.json) {
      printJson(out, {{"outputs", pathsJson(planned)}, {"result", result}, {"stats", stats}, {"warnings", warnings_}});
      return;
    }
    result["size"] = fmt::format("{} x {} pixels", options.width, options.height);
    for (const char* name : {"width", "height"}) result.erase(name);
    result.update(stats);
    result["written"] = output_;
    printRows(out, rowsOf(result));
    for (const std::string& warning : warnings_) invocation_.terminal.err << "blossom: warning: " << warning << '\n';
  }

  Invocation& invocation_;
  CLI::App& app_;
  std::vector<std::string> files_, warnings_;
  std::string output_;
  bool light_ = false;
  std::unique_ptr<ParameterFlags> options_;
};

}  // namespace

void addRenderCommand(CommandLine& line, Invocation& invocation) {
  if (invocation.app.formats->find("png")) line.keep(std::make_shared<RenderCommand>(line, invocation));
}

}  // namespace blossom
