#pragma once
// Private to the room: JSON objects, a member after the other.
#include <string_view>

#include "base/text/text.hpp"

namespace strandline::formats {

/// An object's members, one after the other.
class Members {
  public:
    explicit Members(Text& text) : text_(text) { add(text_, "{"); }
    Members& operator()(const char* key, double value) {
        return put(key, [&] { add_number(text_, value); });
    }
    Members& operator()(const char* key, int value) {
        return put(key, [&] { add_number(text_, static_cast<long long>(value)); });
    }
    Members& operator()(const char* key, std::string_view value) {
        return put(key, [&] { add_string(text_, value); });
    }
    void flag(const char* key, bool value) {
        put(key, [&] { add(text_, value ? "true" : "false"); });
    }
    template <class List, class What>
    void list(const char* key, const List& items, What&& what) {
        put(key, [&] {
            add(text_, "[");
            bool first = true;
            for (const auto& item : items) {
                add(text_, first ? "\n  " : ",\n  ");
                first = false;
                what(item);
            }
            add(text_, "]");
        });
    }
    template <class What>
    void object(const char* key, What&& what) {
        put(key, [&] {
            Members one(text_);
            what(one);
            one.close();
        });
    }
    void close() { add(text_, "}"); }

  private:
    template <class Write>
    Members& put(const char* key, Write&& write) {
        add(text_, first_ ? "" : ",");
        first_ = false;
        add_string(text_, key);
        add(text_, ":");
        write();
        return *this;
    }
    Text& text_;
    bool first_ = true;
};

}  // namespace strandline::formats
