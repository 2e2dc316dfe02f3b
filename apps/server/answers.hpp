#pragma once
// What the API's replies say, and how its calls are read.
#include <string>
#include <string_view>
#include <vector>

#include "api.hpp"

namespace strandline::serve {

Reply json_reply(int status, std::string body);

std::vector<std::string> path_parts(const std::string& path);  ///< at least one
std::string value_in(const std::map<std::string, std::string>& values, const std::string& key,
                     const std::string& otherwise);
/// {"revision": N}.
Outcome<long long> revision_in(std::string_view body);
Outcome<long long> revision_in_query(const Call& call);
/// {"text", "font", "height", "align"}.
Outcome<Lettering> lettering_in(std::string_view body);

bool is_project_text(std::string_view bytes);
/// Error: neither SVG nor PNG nor JPEG; one that cannot be read, with the place in the file; an SVG without a
/// shape. Reads the whole file.
Outcome<void> is_drawing(const SourceFile& file);

std::string about_text(const Setup& setup);
std::string list_text(const std::vector<std::string>& ids);
std::string id_text(const std::string& id);
std::string standing_text(const Workspace& workspace);
/// Lines in metres, y up, their box's lower left at the origin, as a DrawEdit has them.
std::string lettered_text(const svg::Document& document);
/// Of the newest plan. 409 while that is being made: nobody should take an old plan to the beach.
Reply export_reply(const Exporter& exporter, const Standing& standing, const std::string& id);

}  // namespace strandline::serve
