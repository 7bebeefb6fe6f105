// Scrolls the sidebar to the current page.
document.addEventListener("DOMContentLoaded", () => {
  const sidebar = document.querySelector(".sidebar-scroll");
  const page = sidebar && sidebar.querySelector(".current-page");
  if (page) sidebar.scrollTop += page.getBoundingClientRect().top - sidebar.getBoundingClientRect().top - sidebar.clientHeight / 2;
});
