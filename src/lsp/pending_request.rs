//! A request on its way to an answer.

use super::answers::Lane;
use super::snapshot::{Answer, Failure, Snapshot};
use lsp_server::{ErrorCode, Message, Request, RequestId, Response};
use serde_json::Value;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Computes the result of a request, and a request to the client that follows it.
type AnswerJob = Box<dyn FnOnce(&Snapshot) -> Answer<(Value, Option<Request>)> + Send>;

/// A request that was read, but not answered.
pub struct PendingRequest {
    /// Id of the request.
    pub id: RequestId,
    /// Where it should be handled.
    pub lane: Lane,
    job: AnswerJob,
}

impl PendingRequest {
    /// A request with the function that answers it.
    pub(super) fn new(
        id: RequestId,
        lane: Lane,
        job: impl FnOnce(&Snapshot) -> Answer<(Value, Option<Request>)> + Send + 'static,
    ) -> PendingRequest {
        PendingRequest {
            id,
            lane,
            job: Box::new(job),
        }
    }

    /// The answer, and a request to the client. The order matters: what the client does next may
    /// make the answer stale.
    pub fn answer(self, snapshot: &Snapshot) -> (Response, Option<Message>) {
        let job = self.job;
        match guarded(|| job(snapshot)) {
            Ok((value, request)) => (Response::new_ok(self.id, value), request.map(Message::from)),
            Err(failure) => (
                Response::new_err(self.id, failure.code as i32, failure.message),
                None,
            ),
        }
    }
}

/// Runs a handler; a panic loses one answer only.
pub fn guarded<T>(work: impl FnOnce() -> Answer<T>) -> Answer<T> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| {
        Err(Failure {
            code: ErrorCode::InternalError,
            message: "internal error: shaderlint crashed on this request; please report it"
                .to_string(),
        })
    })
}
