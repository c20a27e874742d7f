#include <fmt/core.h>

#include <memory>
#include <string>

#include "commands.hpp"
#include "console.hpp"
#include "echoway/import/import.hpp"
#include "echoway/io/atomic_file.hpp"
#include "option_checks.hpp"

namespace echoway::tools {
namespace {

struct Options {
  std::string format, source, out, report;
};

std::string summary(const Building& building, const import::LonLat& centre, const import::Report& report) {
  using Kind = import::ReportItem::Kind;
  return fmt::format("{}: {} rooms, {} doors, {} links between levels, {} exits, {} places\n"
                     "origin of all levels: {:.7f}, {:.7f} (latitude, longitude); x east, y north, metres\n"
                     "{} repaired, {} unresolved\n",
                     building.name.empty() ? "the building" : building.name, building.rooms.size(),
                     building.doors.size(), building.links.size(), building.exits.size(), building.places.size(),
                     centre.lat, centre.lon, report.count(Kind::repaired), report.count(Kind::unresolved));
}

int run(const Options& options) {
  const Result<import::SourceFormat> format = import::parse_source_format(options.format);
  if (!format) return bad_input(format.error());
  import::Report report;
  const Result<import::ImportedBuilding> imported = import::import_building(*format, options.source, report);
  std::string text;
  for (const import::ReportItem& item : report.items()) text += item.to_string() + "\n";
  std::vector<Finding> findings;
  Status done = imported ? import::write_imported(imported->building, options.out, findings) : imported.error();
  if (done) {
    for (const Finding& finding : findings) text += "check: " + finding.message + "\n";
    text += summary(imported->building, imported->centre, report);
  }
  fmt::print("{}", text);
  if (done && !options.report.empty()) done = write_file(options.report, text);
  return done ? 0 : bad_input(done.error());
}

}  // namespace

void add_import(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("import", "Turn a venue's plan into a building folder");
  auto options = std::make_shared<Options>();
  command
      ->add_option("FORMAT", options->format,
                   "imdf: IMDF, a folder or a zip archive\n"
                   "osm: OpenStreetMap XML with Simple Indoor Tagging\n"
                   "wrld: WRLD indoor map 1.0.0, a folder or a zip archive")
      ->required();
  command->add_option("SOURCE", options->source, "The plan")->required()->check(not_empty());
  command->add_option("--out", options->out, "Building folder to write")->required()->check(not_empty());
  command->add_option("--report", options->report, "Also write every repair and every open question to this file");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace echoway::tools
