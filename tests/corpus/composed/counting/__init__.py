"""How many, of what, and which of them: stocks told in every form, and wishes that speak of them."""
