"""Definitions and references in the scheduler's C++ and the contract's headers, as libclang parses them.

The files' texts come from the book; what they include and the book does not have (the rest of host/, OpenCL, GLM, fmt) comes from the repository
and the system. Classes qualify the names of their members, namespaces and the contract's structs do not.
"""
from collections import namedtuple

import clang.cindex as clang
from clang.cindex import CursorKind

from fragments import ROOT, BookError

# Both are at a file's path, line and column (from 1). kind: function, method, class ...
Defined = namedtuple("Defined", "path line column name kind")
Referred = namedtuple("Referred", "path line column name")

FLAGS = ["-x", "c++", "-std=c++20", f"-I{ROOT}/host", f"-I{ROOT}/include", "-isystem", "/usr/include/Imath", "-DCL_TARGET_OPENCL_VERSION=120",
         "-DFMT_SHARED", "-DGLM_FORCE_CTOR_INIT"]
KINDS = {CursorKind.FUNCTION_DECL: "function", CursorKind.FUNCTION_TEMPLATE: "function", CursorKind.CXX_METHOD: "method", CursorKind.FIELD_DECL: "member",
         CursorKind.STRUCT_DECL: "struct", CursorKind.CLASS_DECL: "class", CursorKind.CLASS_TEMPLATE: "class", CursorKind.UNION_DECL: "union",
         CursorKind.ENUM_DECL: "enum", CursorKind.ENUM_CONSTANT_DECL: "enumerator", CursorKind.TYPEDEF_DECL: "typedef",
         CursorKind.TYPE_ALIAS_DECL: "typedef", CursorKind.VAR_DECL: "variable", CursorKind.MACRO_DEFINITION: "macro"}
SCOPES = {CursorKind.STRUCT_DECL, CursorKind.CLASS_DECL, CursorKind.CLASS_TEMPLATE}
FUNCTIONS = {CursorKind.FUNCTION_DECL, CursorKind.FUNCTION_TEMPLATE, CursorKind.CXX_METHOD, CursorKind.CONSTRUCTOR, CursorKind.DESTRUCTOR, CursorKind.LAMBDA_EXPR}
# One unit includes all, so that what they include is parsed once.
UNIT = str(ROOT / "host" / "all_of_the_book.cpp")


def is_in_contract(cursor):
    return "/include/eikonal/" in cursor.location.file.name


def qualified(cursor):
    if cursor.kind is CursorKind.FIELD_DECL and is_in_contract(cursor):
        return f".{cursor.spelling}"  # as in kernels, of which no parse here tells the struct
    parent = cursor.semantic_parent
    return f"{parent.spelling}::{cursor.spelling}" if parent and parent.kind in SCOPES and parent.spelling else cursor.spelling


def is_indexed(cursor):
    """Whether the declaration is no local and no parameter."""
    if cursor.kind not in KINDS or not cursor.spelling:
        return False
    return cursor.kind in (CursorKind.MACRO_DEFINITION, CursorKind.FIELD_DECL) or cursor.semantic_parent.kind not in FUNCTIONS


class Parser:
    """defined and referred: what the files of `texts` (path -> text) hold."""

    def __init__(self, texts):
        self.texts = {str(ROOT / path): text for path, text in texts.items()}
        self.lines = {name: text.split("\n") for name, text in self.texts.items()}
        includes = "".join(f'#include "{path.split("/", 1)[1]}"\n' for path in sorted(texts))
        unit = clang.Index.create().parse(UNIT, FLAGS, [*self.texts.items(), (UNIT, includes)], clang.TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)
        for diagnostic in unit.diagnostics:
            if diagnostic.severity == clang.Diagnostic.Fatal:
                raise BookError(f"clang: {diagnostic.location.file}:{diagnostic.location.line}: {diagnostic.spelling}")
        self.defined, self.referred = set(), set()
        self._walk(unit.cursor)

    def _walk(self, cursor):
        for child in cursor.get_children():
            file = child.location.file
            if file and file.name in self.texts:
                self._note(child)
                self._walk(child)
            elif child.spelling == "eikonal":  # only the program's namespace: the bindings do not know all kinds of the library's cursors
                self._walk(child)

    def _is_written(self, location, name):
        """Whether the name stands there; what a macro expands to does not."""
        line = self.lines[location.file.name][location.line - 1]
        return line.startswith(name, location.column - 1)

    def _note(self, cursor):
        location, target = cursor.location, cursor.referenced
        place = (location.file.name.removeprefix(f"{ROOT}/"), location.line, location.column)
        if is_indexed(cursor):
            if self._is_written(location, cursor.spelling):
                self.defined.add(Defined(*place, qualified(cursor), KINDS[cursor.kind] if cursor.is_definition() or cursor.kind is CursorKind.MACRO_DEFINITION else "declaration"))
        elif target and target.location.file and target.location.file.name in self.texts and is_indexed(target):
            if self._is_written(location, target.spelling):
                self.referred.add(Referred(*place, qualified(target)))
