#include "source/osm_document.hpp"

#include <expat.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>

#include "source/limits.hpp"
#include "source/source_error.hpp"
#include "source/source_tree.hpp"

namespace echoway::import {
namespace {

// Fed by expat, which streams: nothing but the document's own objects is kept. Errors may not pass through expat's C
// frames, so the first one is kept and the parser is stopped.
class Builder {
 public:
  explicit Builder(std::string file) : parser_(XML_ParserCreate(nullptr), XML_ParserFree) {
    document_.file = std::move(file);
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(
        parser_.get(),
        [](void* self, const XML_Char* name, const XML_Char** attributes) {
          static_cast<Builder*>(self)->start(name, attributes);
        },
        [](void* self, const XML_Char* name) { static_cast<Builder*>(self)->end(name); });
    XML_SetEntityDeclHandler(parser_.get(), [](void* self, const XML_Char*, int, const XML_Char*, int, const XML_Char*,
                                               const XML_Char*, const XML_Char*, const XML_Char*) {
      static_cast<Builder*>(self)->fail("declares an entity, which no OpenStreetMap file does");
    });
  }

  OsmDocument parse(const std::string& text) {
    const XML_Status status = XML_Parse(parser_.get(), text.data(), static_cast<int>(text.size()), XML_TRUE);
    if (error_) throw SourceError(*error_);
    if (status != XML_STATUS_OK) {
      throw SourceError(
          Error{std::string("is not well-formed XML: ") + XML_ErrorString(XML_GetErrorCode(parser_.get())),
                document_.file, line()});
    }
    if (!saw_osm_) throw SourceError(Error{"is not an OpenStreetMap XML file: no <osm> element", document_.file, 0});
    return std::move(document_);
  }

 private:
  [[nodiscard]] int line() const { return static_cast<int>(XML_GetCurrentLineNumber(parser_.get())); }

  void fail(const std::string& what) {
    if (!error_) error_ = Error{what, document_.file, line()};
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  static const char* find(const XML_Char** attributes, const char* key) {
    for (; *attributes != nullptr; attributes += 2) {
      if (std::strcmp(attributes[0], key) == 0) return attributes[1];
    }
    return nullptr;
  }

  std::optional<OsmId> id(const XML_Char** attributes, const char* key) {
    const char* text = find(attributes, key);
    char* rest = nullptr;
    errno = 0;
    const long long value = text == nullptr ? 0 : std::strtoll(text, &rest, 10);
    if (text == nullptr || rest == text || *rest != '\0' || errno != 0) {
      fail(std::string("'") + key + "' is not a whole number");
      return std::nullopt;
    }
    return value;
  }

  std::optional<double> degrees_of(const XML_Char** attributes, const char* key, double bound) {
    const char* text = find(attributes, key);
    char* rest = nullptr;
    const double value = text == nullptr ? 0.0 : std::strtod(text, &rest);
    if (text == nullptr || rest == text || *rest != '\0' || !std::isfinite(value) || std::abs(value) > bound) {
      fail(std::string("'") + key + "' is not an angle in degrees");
      return std::nullopt;
    }
    return value;
  }

  void start(const std::string& name, const XML_Char** attributes) {
    if (error_) return;
    if (++depth_ > kMaxNesting) return fail("is nested too deeply for a floor plan");
    if (++elements_ > kMaxElements) return fail("holds too many elements for a floor plan");
    if (name == "osm") saw_osm_ = true;
    if (name == "node") start_node(attributes);
    if (name == "way") start_object(attributes, document_.ways);
    if (name == "relation") start_object(attributes, document_.relations);
    if (name == "tag") add_tag(attributes);
    if (name == "nd") add_way_node(attributes);
    if (name == "member") add_member(attributes);
  }

  void end(const std::string& name) {
    --depth_;
    if (name == "node" || name == "way" || name == "relation") {
      tags_ = nullptr;
      way_ = nullptr;
      relation_ = nullptr;
    }
  }

  static bool deleted(const XML_Char** attributes) {
    const char* action = find(attributes, "action");
    const char* visible = find(attributes, "visible");
    return (action != nullptr && std::strcmp(action, "delete") == 0) ||
           (visible != nullptr && std::strcmp(visible, "false") == 0);
  }

  void start_node(const XML_Char** attributes) {
    if (deleted(attributes)) return;
    const auto key = id(attributes, "id");
    const auto lat = degrees_of(attributes, "lat", 89.9), lon = degrees_of(attributes, "lon", 180.0);
    if (!key || !lat || !lon) return;
    OsmNode& node = document_.nodes[*key];
    node.at = {*lon, *lat};
    node.line = line();
    tags_ = &node.tags;
  }

  template <class Objects>
  void start_object(const XML_Char** attributes, Objects& objects) {
    if (deleted(attributes)) return;
    const auto key = id(attributes, "id");
    if (!key) return;
    auto& object = objects[*key];
    object.line = line();
    tags_ = &object.tags;
    remember(object);
  }
  void remember(OsmWay& way) { way_ = &way; }
  void remember(OsmRelation& relation) { relation_ = &relation; }

  void add_tag(const XML_Char** attributes) {
    const char* key = find(attributes, "k");
    const char* value = find(attributes, "v");
    if (tags_ != nullptr && key != nullptr && value != nullptr) (*tags_)[key] = value;
  }

  void add_way_node(const XML_Char** attributes) {
    if (way_ == nullptr) return;
    if (const auto ref = id(attributes, "ref")) way_->nodes.push_back(*ref);
  }

  void add_member(const XML_Char** attributes) {
    if (relation_ == nullptr) return;
    const char* type = find(attributes, "type");
    const char* role = find(attributes, "role");
    const auto ref = id(attributes, "ref");
    if (ref && type != nullptr) relation_->members.push_back({type, *ref, role == nullptr ? "" : role});
  }

  std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser_;
  OsmDocument document_;
  std::optional<Error> error_;
  OsmTags* tags_ = nullptr;
  OsmWay* way_ = nullptr;
  OsmRelation* relation_ = nullptr;
  int depth_ = 0;
  std::size_t elements_ = 0;
  bool saw_osm_ = false;
};

}  // namespace

OsmDocument read_osm_document(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  return Builder(path.string()).parse(text);
}

}  // namespace echoway::import
