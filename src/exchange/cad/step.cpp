#include <netdb.h>
#include <unistd.h>

#include <APIHeaderSection_MakeHeader.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Interface_Check.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_RepresentationContext.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepVisual_MechanicalDesignGeometricPresentationRepresentation.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <fstream>

#include "core/version.h"
#include "exchange/cad/brep_export.h"
#include "exchange/cad/brep_import.h"
#include "exchange/cad/occt_io.h"
#include "exchange/cad/xcaf_read.h"
#include "exchange/cad/xcaf_write.h"
#include "exchange/format/axis_curves.h"

namespace blossom {

namespace {

namespace fs = std::filesystem;

void requireEnd(const std::string& path) {
  if (tailOf(path, 4096).find("END-ISO-10303-21") != std::string::npos) return;
  throw Error(ErrorCode::FormatDamaged, "Its end is missing (END-ISO-10303-21): it was cut off or not written completely.",
              "Fetch or export the file again.");
}

Handle(StepData_StepModel) stepModel(const STEPControl_Reader& reader) {
  return Handle(StepData_StepModel)::DownCast(reader.WS()->Model());
}

/// Syntax errors, and entities whose values are missing or of the wrong sort.
int countProblems(const Handle(StepData_StepModel) & model) {
  int count = model->GlobalCheck(Standard_True)->NbFails();
  for (int i = 1; i <= model->NbEntities(); ++i) count += model->Check(i, Standard_True)->HasFailed();
  return count;
}

std::vector<std::string> readingProblems(const STEPControl_Reader& reader) {
  const int count = countProblems(stepModel(reader));
  if (count == 0) return {};
  return {"The file breaks the rules of STEP in " + std::to_string(count) + (count == 1 ? " place" : " places") +
          "; something may be missing."};
}

const char* schemaSetting(const std::string& schema) {
  if (schema == "ap203") return "AP203";
  return schema == "ap242" ? "AP242DIS" : "AP214IS";
}

/// An AP 203 file names who made it and on which machine. OCCT 7.6 looks the machine's own name up for that and crashes when
/// it has no address (OSD_Host::InternetAddress), so this asks first.
void requireHostAddress() {
  char name[256] = {};
  if (::gethostname(name, sizeof name - 1) == 0 && ::gethostbyname(name)) return;
  throw Error(ErrorCode::OutputNotSupported, "AP 203 cannot be written here: this computer's own name has no address.",
              "Write AP 214 or AP 242, or add the computer's name to /etc/hosts.");
}

/// `path` is temporary when this is written, so the file is named after its content.
void fillHeader(STEPControl_Writer& writer, const Brep& brep) {
  const auto text = [](const std::string& value) { return new TCollection_HAsciiString(value.c_str()); };
  APIHeaderSection_MakeHeader header(writer.Model());
  const std::string name = brep.roots().front().name;
  header.SetName(text(name.empty() ? "Shape" : name));
  header.SetAuthorValue(1, text(""));
  header.SetOrganizationValue(1, text(""));
  header.SetOriginatingSystem(text(std::string("Blossom ") + versionText));
  header.SetPreprocessorVersion(text("Open CASCADE Technology"));
  header.SetAuthorisation(text(""));
  header.SetDescriptionValue(1, text("Blossom model"));
}

using Presentation = Handle(StepVisual_MechanicalDesignGeometricPresentationRepresentation);

/// OCCT lists the colours of parts by the addresses of these, which are others in every process. Here they come in the order
/// of what they colour.
Handle(StepData_StepModel) withOrderedColors(const Handle(StepData_StepModel) & model) {
  std::vector<std::pair<std::pair<int, int>, Presentation>> colors;
  int firstNumber = model->NbEntities() + 1;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Presentation presentation = Presentation::DownCast(model->Value(i));
    if (presentation.IsNull()) continue;
    firstNumber = std::min(firstNumber, i);
    const Handle(StepVisual_StyledItem) styled =
        presentation->NbItems() > 0 ? Handle(StepVisual_StyledItem)::DownCast(presentation->ItemsValue(1)) : nullptr;
    colors.push_back({{model->Number(presentation->ContextOfItems()), styled.IsNull() ? 0 : model->Number(styled->Item())},
                      presentation});
  }
  std::stable_sort(colors.begin(), colors.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Handle(StepData_StepModel) ordered = new StepData_StepModel;
  ordered->GetFromAnother(model);
  ordered->SetProtocol(model->Protocol());
  for (int i = 1; i < firstNumber; ++i) ordered->AddEntity(model->Value(i));
  for (const auto& [place, presentation] : colors) ordered->AddWithRefs(presentation);
  for (int i = firstNumber; i <= model->NbEntities(); ++i)
    if (!ordered->Contains(model->Value(i))) ordered->AddEntity(model->Value(i));
  return ordered;
}

/// As STEPControl_Writer::Write, but with all digits.
bool print(STEPControl_Writer& writer, const std::string& path) {
  StepData_StepWriter text(withOrderedColors(writer.Model()));
  text.FloatWriter().SetFormat(exactNumber);
  text.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
  std::ofstream stream(path, std::ios::binary);
  const bool printed = text.Print(stream);
  stream.close();
  return printed && stream.good();
}

}  // namespace

void writeStep(const Brep& brep, const std::string& path, const Value& options, const Progress& progress) {
  if (options.value("schema", "ap214") == "ap203") requireHostAddress();
  const OcctSession session;
  const OcctSetting unit("write.step.unit", "MM");
  const OcctSetting schema("write.step.schema", schemaSetting(options.value("schema", "ap214")));
  const OcctSetting curvesOnSurfaces("write.surfacecurve.mode", 1);
  const OcctSetting product("write.step.product.name", "Shape");
  withOcctErrors(ErrorCode::FileUnwritable, "The shape cannot be written as STEP.", [&] {
    STEPCAFControl_Writer writer;
    writer.SetPropsMode(Standard_False);
    Handle(OcctProgress) watcher = new OcctProgress(progress, "Writing");
    const bool transferred = writer.Transfer(toDocument(brep), STEPControl_AsIs, nullptr, watcher->Start());
    progress.check();
    if (!transferred) throw Error(ErrorCode::InvalidInput, "The shape holds something that STEP cannot hold.");
    fillHeader(writer.ChangeWriter(), brep);
    if (!print(writer.ChangeWriter(), path))
      throw Error(ErrorCode::FileUnwritable, "The file \"" + path + "\" cannot be written.",
                  "Check the folder and the space left.");
  });
}

BrepImport readStep(const std::string& path, const Progress& progress) {
  requireEnd(path);
  const OcctSession session;
  const OcctSetting unit("xstep.cascade.unit", "MM");
  return withOcctErrors(ErrorCode::FormatDamaged, "It cannot be understood as STEP.", [&] {
    progress.report(0, "Reading");
    STEPCAFControl_Reader reader;
    reader.SetPropsMode(Standard_False);
    reader.SetGDTMode(Standard_False);
    reader.SetMatMode(Standard_False);
    reader.SetViewMode(Standard_False);
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
      throw Error(ErrorCode::FormatDamaged, "It breaks the rules of STEP so badly that nothing can be read.");
    Handle(TDocStd_Document) document = newDocument();
    Handle(OcctProgress) watcher = new OcctProgress(progress.part(0.4, 1), "Building shapes");
    reader.Transfer(document, watcher->Start());
    return BrepImport{fromDocument(document), Value::object(), readingProblems(reader.Reader())};
  });
}

Format stepFormat() {
  ParameterSpec schema = choice({"ap203", "ap214", "ap242"});
  schema.name = "schema";
  schema.help = "Application protocol of the file.";
  schema.fallback = "ap214";
  Format format;
  format.id = "step";
  format.title = "STEP (AP 203, 214, 242)";
  format.extensions = {"step", "stp"};
  format.writeOptions.push_back(schema);
  format.read = [](const fs::path& path, const Value&, const Progress& progress) {
    return importBrep("step.read", path, progress);
  };
  format.writeOptions.push_back(heightsOption(true));
  format.write = [](const Shape& shape, const fs::path& path, const Value& options, const Progress& progress) {
    exportBrep("step.write", toBrep(shape, options), path, options, progress);
  };
  format.writes = brepKinds();
  return format;
}

}  // namespace blossom
