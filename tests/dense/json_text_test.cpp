// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/dense/json_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace silt::dense {
namespace {

TEST(JsonText, WritesOneObject) {
  JsonText inner, json;
  inner.Add("x", 0.25).AddFlag("good", true);
  json.Add("name", "a \"b\" \\ \n").AddObject("inner", inner).AddNull("later");
  EXPECT_EQ(json.Text(),
            "{\"name\": \"a \\\"b\\\" \\\\ \\u000a\", \"inner\": {\"x\": 0.25, \"good\": true}, "
            "\"later\": null}");
}

TEST(JsonText, WhatIsNoNumberIsNull) {
  JsonText json;
  json.Add("a", NAN).Add("b", HUGE_VAL);
  EXPECT_EQ(json.Text(), "{\"a\": null, \"b\": null}");
}

TEST(JsonText, OfNothingIsEmpty) { EXPECT_EQ(JsonText().Text(), "{}"); }

}  // namespace
}  // namespace silt::dense
