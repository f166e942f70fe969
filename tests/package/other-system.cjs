// Loaded before everything else: makes Node, and so npm, believe that this is a system without programs.
"use strict";

Object.defineProperty(process, "platform", { value: "freebsd" });
