#include <fmt/format.h>

#include <ostream>

#include "cli/command_line.h"
#include "cli/input.h"
#include "cli/output.h"
#include "cli/progress_display.h"
#include "cli/report.h"
#include "scene/scene.h"

namespace blossom {
namespace {

/// A picture of files, drawn without a display. Its flags are the write options of the PNG format.
class RenderCommand {
 public:
  RenderCommand(CommandLine& line, Session& session)
      : session_(session),
        app_(line.add("render", "Draw files into a PNG picture; needs no display.", session, [this] { return run(); })) {
    app_.add_option("FILE", files_, "Files to draw together (or model.blossom#feature).")->type_name("..")->expected(0, -1);
    app_.add_option("-o,--output", output_, "The picture.")->type_name("FILE.png");
    app_.add_flag("--light", light_, "The same as --theme light.");
    CommandLine::addDocumentFlags(app_, session_);
    options_ = std::make_unique<ParameterFlags>(line, app_, session.app.formats->find("png")->writeOptions, "", "Picture");
    setExamples(app_,
                {"blossom render part.step -o part.png", "blossom render propeller.json -o p.png --size 1920x1080 --light"});
  }

 private:
  /// What the window would show of the file: every visible feature of its document, or the last one if all are hidden.
  void addShapes(const std::string& text, const Progress& progress, std::vector<Shape>& shapes) {
    const std::filesystem::path file = fileOfInput(text);
    if (file.string() != text) {
      Document document;
      const FeatureId id = addInput(session_, document, text, warnings_);
      shapes.push_back(evaluateFor(session_.app, document, id, progress)->evaluated.shape);
      return;
    }
    const OpenedDocument opened = openInput(session_, file);
    warnings_.insert(warnings_.end(), opened.warnings.begin(), opened.warnings.end());
    const FeatureId last = lastFeature(opened.document).id;
    Results results;
    const auto result = evaluateFor(session_.app, opened.document, last, progress, &results);
    const std::size_t before = shapes.size();
    for (const auto& feature : opened.document.features())
      if (const auto found = results.find(feature->id);
          feature->visible && found != results.end() && !found->second->evaluated.shape.empty())
        shapes.push_back(found->second->evaluated.shape);
    if (shapes.size() == before) shapes.push_back(result->evaluated.shape);
  }

  int run() {
    if (files_.empty())
      throw UsageError("render needs a file to draw.", "\"blossom render part.step -o part.png\" draws a part.");
    if (output_.empty()) throw UsageError("render needs a picture to write.", "Add -o and a name that ends in .png.");
    Value values = options_->given();
    if (light_) values["theme"] = "light";
    PictureOptions options;
    try {
      options = readPictureOptions(values);
    } catch (const Error& error) {
      throw UsageError(error.message(), error.hint(), error.code());
    }
    std::vector<std::filesystem::path> inputs;
    for (const std::string& file : files_) inputs.push_back(fileOfInput(file));
    const auto planned = plannedOutputs(*session_.app.formats, {output_}, inputs, nullptr);
    if (!planned[0].format || planned[0].format->id != "png")
      throw Error(ErrorCode::FormatUnknown, fmt::format("The picture {} is no PNG file.", output_),
                  "Give it a name that ends in .png.");

    ProgressDisplay display(session_);
    const Progress progress = display.progress();
    std::vector<Shape> shapes;
    for (const std::string& file : files_) addShapes(file, progress.part(0, 0.5), shapes);
    const Stopwatch drawing;
    renderPicture(shapes, output_, options, progress.part(0.5, 1));
    report(planned, options, drawing.elapsedMs());
    return 0;
  }

  void report(const std::vector<Output>& planned, const PictureOptions& options, double drawMs) const {
    Value result{{"kind", "picture"}, {"width", options.width}, {"height", options.height}};
    Value stats{{"render_ms", drawMs}, {"total_ms", session_.elapsedMs()}};
    std::ostream& out = session_.terminal.out;
    if (session_.json) {
      printJson(out, {{"outputs", pathsJson(planned)}, {"result", result}, {"stats", stats}, {"warnings", warnings_}});
      return;
    }
    result["size"] = fmt::format("{} x {} pixels", options.width, options.height);
    for (const char* name : {"width", "height"}) result.erase(name);
    result.update(stats);
    result["written"] = output_;
    printRows(out, rowsOf(result));
    for (const std::string& warning : warnings_) session_.terminal.err << "blossom: warning: " << warning << '\n';
  }

  Session& session_;
  CLI::App& app_;
  std::vector<std::string> files_, warnings_;
  std::string output_;
  bool light_ = false;
  std::unique_ptr<ParameterFlags> options_;
};

}  // namespace

void addRenderCommand(CommandLine& line, Session& session) {
  if (session.app.formats->find("png")) line.keep(std::make_shared<RenderCommand>(line, session));
}

}  // namespace blossom
