#pragma once
// What a connection would be if it were led through poses: asked while a point is dragged.
#include "answers.hpp"

namespace strandline::serve {

/// Body: {"plan", "connection", "through"}; openapi.json, LeadingWish. Changes nothing.
Reply leading_reply(const Workspace& workspace, std::string_view body);

}  // namespace strandline::serve
