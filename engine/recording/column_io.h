// SPDX-License-Identifier: MIT
// What is done with the lists of columns.h: declare the columns of a table, put a value into a
// statement, get it back.
#pragma once

#include <string>
#include <type_traits>

#include "engine/recording/columns.h"
#include "engine/recording/sqlite.h"

namespace svoscope {

/// "a REAL, b INTEGER, ..." of CREATE TABLE, the same without types, and as many question marks.
class ColumnList {
 public:
  template <typename T>
  void operator()(const char* name, const T&) {
    if constexpr (std::is_floating_point_v<T>)
      add(name, "REAL");
    else if constexpr (std::is_same_v<T, SE3>)
      for (const char* c : {"tx", "ty", "tz", "qx", "qy", "qz", "qw"})
        add(name + std::string(c), "REAL");
    else if constexpr (std::is_same_v<T, Vec2f>)
      for (const char* c : {"_x", "_y"}) add(name + std::string(c), "REAL");
    else if constexpr (std::is_same_v<T, Vec3f>)
      for (const char* c : {"_x", "_y", "_z"}) add(name + std::string(c), "REAL");
    else if constexpr (std::is_same_v<T, BeliefView>)
      for (const char* c : {"_mu", "_sigma", "_a", "_b"}) add(name + std::string(c), "REAL");
    else if constexpr (std::is_same_v<T, std::string>)
      add(name, "TEXT");
    else
      add(name, "INTEGER");
  }
  template <typename T>
  void operator()(const char* name, Named<T>) {
    add(name, "TEXT");
  }

  void add(const std::string& name, const std::string& type) {
    const char* comma = names.empty() ? "" : ", ";
    declarations += comma + name + " " + type;
    names += comma + name;
    marks += std::string(comma) + "?";
  }
  std::string declarations, names, marks;
};

class PutColumns {
 public:
  explicit PutColumns(Query& query) : q_(query) {}
  template <typename T>
  void operator()(const char*, const T& v) {
    if constexpr (std::is_enum_v<T> || std::is_integral_v<T>)
      q_.put(static_cast<std::int64_t>(v));
    else if constexpr (std::is_floating_point_v<T>)
      q_.put(static_cast<double>(v));
    else if constexpr (std::is_same_v<T, std::string>)
      q_.put(v);
    else if constexpr (std::is_same_v<T, BeliefView>)
      for (const float c : {v.mu, v.sigma, v.a, v.b}) q_.put(static_cast<double>(c));
    else if constexpr (std::is_same_v<T, SE3>) {
      for (int i = 0; i < 3; ++i) q_.put(v.translation()[i]);
      for (int i = 0; i < 4; ++i) q_.put(v.quaternion().coeffs()[i]);
    } else
      for (int i = 0; i < v.size(); ++i) q_.put(static_cast<double>(v[i]));
  }
  template <typename T>
  void operator()(const char*, Named<T> v) {
    q_.put(nameOf(v.value));
  }

 private:
  Query& q_;
};

class GetColumns {
 public:
  explicit GetColumns(Query& query) : q_(query) {}
  template <typename T>
  void operator()(const char*, T& v) {
    if constexpr (std::is_enum_v<T>)
      v = valueOfCode<T>(q_.integer());
    else if constexpr (std::is_integral_v<T>)
      v = static_cast<T>(q_.integer());
    else if constexpr (std::is_floating_point_v<T>)
      v = static_cast<T>(q_.real());
    else if constexpr (std::is_same_v<T, std::string>)
      v = q_.text();
    else if constexpr (std::is_same_v<T, BeliefView>)
      for (float* c : {&v.mu, &v.sigma, &v.a, &v.b}) *c = static_cast<float>(q_.real());
    else if constexpr (std::is_same_v<T, SE3>) {
      Vec3 t;
      Eigen::Quaterniond q;
      for (int i = 0; i < 3; ++i) t[i] = q_.real();
      for (int i = 0; i < 4; ++i) q.coeffs()[i] = q_.real();
      v = SE3::fromParts(q, t);
    } else
      for (int i = 0; i < v.size(); ++i) v[i] = static_cast<float>(q_.real());
  }
  template <typename T>
  void operator()(const char*, Named<T> v) {
    v.value = valueOf<T>(q_.text());
  }

 private:
  Query& q_;
};

}  // namespace svoscope
