"""The four passes: schema, codegen, validate, repair. They never import each other."""
