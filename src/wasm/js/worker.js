// The language server as a web worker.

import { serve } from "./serve.js";

serve(self);
