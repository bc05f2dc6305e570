#include "ui/page/view_commands.h"

#include <QMenu>
#include <algorithm>
#include <array>

#include "ui/commands/commands.h"
#include "ui/look/icons.h"
#include "ui/page/page.h"
#include "ui/view/view_widget.h"

namespace blossom::ui {

namespace {

struct PickModeCommand {
  const char* id;
  PickMode mode;
};
constexpr std::array<PickModeCommand, 5> pickModes{{{"select.features", PickMode::Feature},
                                                    {"select.faces", PickMode::Face},
                                                    {"select.edges", PickMode::Edge},
                                                    {"select.points", PickMode::Vertex},
                                                    {"select.any", PickMode::Any}}};

struct DisplayModeCommand {
  const char* id;
  DisplayMode mode;
};
constexpr std::array<DisplayModeCommand, 8> displayModes{{{"view.shaded-edges", DisplayMode::ShadedWithEdges},
                                                          {"view.shaded", DisplayMode::Shaded},
                                                          {"view.wireframe", DisplayMode::Wireframe},
                                                          {"view.zebra", DisplayMode::Zebra},
                                                          {"view.gaussian-curvature", DisplayMode::GaussianCurvature},
                                                          {"view.mean-curvature", DisplayMode::MeanCurvature},
                                                          {"view.largest-curvature", DisplayMode::LargestCurvature},
                                                          {"view.iso-curves", DisplayMode::IsoCurves}}};
constexpr std::size_t plainModes = 3;

constexpr std::array<const char*, 4> timelineCommands{"timeline.play", "timeline.next", "timeline.previous",
                                                      "timeline.onion-skin"};

}  // namespace

ViewCommands::ViewCommands(Commands& commands, std::function<DocumentPage&()> page, QObject* parent)
    : QObject(parent), commands_(commands), page_(std::move(page)) {
  addPickModes();
  addDisplayModes();
  addTools();
  addTimeline();
}

void ViewCommands::addPickModes() {
  const QString group = tr("Select");
  const auto add = [&](const char* id, const char* icon, const QString& text, const QString& help, const char* key) {
    const auto found = std::find_if(pickModes.begin(), pickModes.end(), [&](const auto& each) { return each.id == id; });
    commands_.add({QLatin1String(id), group, QLatin1String(icon), text, help, {QKeySequence(QLatin1String(key))}, true},
                  [this, mode = found->mode] {
                    page_().view().setPickMode(mode);
                    refresh();
                  });
  };
  add(pickModes[0].id, "pick-feature", tr("F&eatures"), tr("A click in the view selects whole features."), "Shift+1");
  add(pickModes[1].id, "pick-face", tr("&Faces"), tr("A click in the view selects faces."), "Shift+2");
  add(pickModes[2].id, "pick-edge", tr("E&dges"), tr("A click in the view selects edges."), "Shift+3");
  add(pickModes[3].id, "pick-vertex", tr("&Points"), tr("A click in the view selects points."), "Shift+4");
  add(pickModes[4].id, "pick-point", tr("&Any part"), tr("A click in the view selects the nearest face, edge or point."),
      "Shift+5");
}

void ViewCommands::addDisplayModes() {
  const QString group = tr("View");
  const auto add = [&](const DisplayModeCommand& each, const char* icon, const QString& text, const QString& help,
                       const QString& keywords = {}) {
    commands_.add(
        {QLatin1String(each.id), group, QLatin1String(icon), text, help, {}, true, keywords.split(u';', Qt::SkipEmptyParts)},
        [this, mode = each.mode] {
          page_().setDisplayMode(mode);
          refresh();
        });
  };
  add(displayModes[0], "edges", tr("Shaded with &edges"), tr("Draw faces and their edges."));
  add(displayModes[1], "shaded", tr("&Shaded"), tr("Draw faces alone."));
  add(displayModes[2], "wireframe", tr("&Wireframe"), tr("Draw edges alone."));
  add(displayModes[3], "zebra", tr("&Zebra stripes"),
      tr("Faces mirror striped surroundings: stripes bend where surfaces do."),
      tr("reflection;continuity;surface quality;highlight lines"));
  add(displayModes[4], "curvature", tr("&Gaussian curvature"),
      tr("Colours of the product of the principal curvatures: domes, saddles, and what can be unrolled."),
      tr("surface quality;colours;developable"));
  add(displayModes[5], "curvature", tr("&Mean curvature"),
      tr("Colours of the mean of the principal curvatures: bulges, hollows and minimal surfaces."),
      tr("surface quality;colours"));
  add(displayModes[6], "curvature", tr("&Largest curvature"),
      tr("Colours of the tightest bend at every place: its radius limits tools and offsets."),
      tr("surface quality;colours;radius;principal curvature"));
  add(displayModes[7], "iso-curves", tr("&Iso-curves"), tr("Draw curves of constant parameter on the faces."),
      tr("isoparametric;parameter lines;surface quality"));
}

void ViewCommands::addTools() {
  const QString group = tr("View");
  commands_.add({"view.measure",
                 group,
                 "measure",
                 tr("&Measure"),
                 tr("Measure lengths, distances, angles, radii and areas by clicking."),
                 {QKeySequence(QStringLiteral("M"))},
                 true,
                 tr("dimension;distance;ruler;length;angle").split(u';')},
                [this] { page_().startMeasuring(); });
  commands_.add({"view.section",
                 group,
                 "section",
                 tr("&Section"),
                 tr("Cut the model open with a plane that can be dragged."),
                 {QKeySequence(QStringLiteral("X"))},
                 true,
                 tr("clip;cross section;cutaway").split(u';')},
                [this] { page_().startSection(); });
}

void ViewCommands::addTimeline() {
  const QString group = tr("Timeline");
  const auto add = [&](const char* id, const char* icon, const QString& text, const QString& help, const char* key, auto go,
                       bool checkable = false) {
    commands_.add({QLatin1String(id), group, QLatin1String(icon), text, help, {QKeySequence(QLatin1String(key))}, checkable},
                  [this, go] { go(page_().playback()); });
  };
  add(timelineCommands[0], "play", tr("&Play or pause"), tr("Run through the frames of the sequence shown."), "Shift+Space",
      [](Playback& playback) { playback.setPlaying(!playback.playing()); });
  add(timelineCommands[1], "chevron-right", tr("&Next frame"), tr("Show the next frame of the sequence."), ".",
      [](Playback& playback) { playback.show(playback.frame() + 1); });
  add(timelineCommands[2], "chevron-left", tr("Pre&vious frame"), tr("Show the frame before."), ",",
      [](Playback& playback) { playback.show(playback.frame() - 1); });
  add(
      timelineCommands[3], "onion-skin", tr("&Onion skin"), tr("Show the other frames of the sequence faintly."), "O",
      [](Playback& playback) { playback.setOnionSkin(!playback.onionSkin()); }, true);
}

void ViewCommands::addTo(QMenu& view, QMenu& select) {
  for (std::size_t i = 0; i < plainModes; ++i) view.addAction(commands_.action(QLatin1String(displayModes[i].id)));
  QMenu* const surfaces = view.addMenu(icon(QStringLiteral("zebra")), tr("Surface &quality"));
  for (std::size_t i = plainModes; i < displayModes.size(); ++i)
    surfaces->addAction(commands_.action(QLatin1String(displayModes[i].id)));
  view.addSeparator();
  for (const char* id : {"view.measure", "view.section"}) view.addAction(commands_.action(QLatin1String(id)));
  view.addSeparator();
  for (const char* id : timelineCommands) view.addAction(commands_.action(QLatin1String(id)));
  for (const PickModeCommand& each : pickModes) select.addAction(commands_.action(QLatin1String(each.id)));
}

void ViewCommands::refresh() {
  for (const char* id : timelineCommands)
    commands_.setEnabled(QLatin1String(id),
                         id == timelineCommands[0] ? page_().playback().playable() : page_().playback().count() > 1,
                         tr("No sequence is shown: a morph with several frames makes one."));
  commands_.action(QStringLiteral("timeline.onion-skin"))->setChecked(page_().playback().onionSkin());
  commands_.action(QStringLiteral("view.measure"))->setChecked(page_().measuring());
  commands_.action(QStringLiteral("view.section"))->setChecked(page_().section().has_value());
  const ViewWidget& view = page_().view();
  for (const PickModeCommand& each : pickModes) {
    QAction* const action = commands_.action(QLatin1String(each.id));
    action->setChecked(view.pickMode() == each.mode);
    if (action->isChecked()) emit pickModeShown(*action);
  }
  for (const DisplayModeCommand& each : displayModes)
    commands_.action(QLatin1String(each.id))->setChecked(view.displayMode() == each.mode);
}

}  // namespace blossom::ui
